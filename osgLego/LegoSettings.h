#pragma once

#include <osgLego/Export.h>
#include <osgLego/GridLimits.h>
#include <osgLego/SettingDescription.h>

#include <cstdint>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The shape of a cell: width to depth to height. */
enum class Proportions
{
    CUBE,  //!< 1:1:1, the cell of the paper
    BRICK, //!< 1:1:1.2, a real brick
    PLATE  //!< 1:1:0.4, a real plate
};

/** The axis of the source's coordinates along which studs point. */
enum class UpAxis
{
    Y, //!< most .obj and .ply files
    Z  //!< OpenSceneGraph's own convention
};

/** The lattice that the cells of a moving source belong to. */
enum class Anchor
{
    FIT,   //!< with a resolution, a grid that is fitted to each state of the source; with a cell, as MODEL
    FIRST, //!< the grid that is fitted to the first state of the source, extended by whole cells
    MODEL, //!< a lattice through the origin of the source's coordinates
    WORLD  //!< a lattice through the origin of the world, in which transforms above a LegoNode move its source
};

/** The samples of a triangle that mark cells as covered. */
enum class VoxelizationMethod
{
    POINTS, //!< the vertices of the subdivided triangles, one point each (the paper, section III-B)
    EXACT   //!< every cell whose box a triangle overlaps (Akenine-Moller's separating-axis test), and no other
};

/** The meaning of a texel in the voxelization's frame buffer object. */
enum class VoxelizationTarget
{
    PROJECTED, //!< a pixel of an orthographic picture with a depth buffer (the paper, Algorithms 3 and 4)
    ADDRESSED  //!< one cell of the grid (the paper's future work)
};

/** The device that makes the bricks. */
enum class Device
{
    AUTO, //!< the CPU if OpenGL is a software renderer and the method is EXACT, otherwise the GPU
    GPU,  //!< the GPU, with the passes of the method
    CPU   //!< the CPU, as legolizeOnCpu() does; only for EXACT
};

/** How bricks are drawn. */
enum class Look
{
    PLAIN, //!< smooth bricks in Phong's lighting model, lit by the scene's lights alone
    FULL   //!< plastic with joints and relief (BrickAppearance), also lit by a probe (LightProbe)
};

/** The technique that draws bricks; the picture is the same. */
enum class Drawing
{
    AUTO,      //!< the faster one on all renderers that were measured: splats
    TRIANGLES, //!< triangles from a geometry shader
    SPLATS     //!< points whose pixels cast rays; triangles if rays can't show the bricks, such as bricks cut open
};

/** The picture of a LegoNode until its first bricks have been made on the CPU. */
enum class Meanwhile
{
    WAIT,   //!< nothing else: the first frame waits for them
    DRAFT,  //!< a draft of their parts (Effort::INSTANT), for which the first frame waits; other bricks have no draft
    SOURCE, //!< the source
    NOTHING //!< nothing; the frame does not wait
};

/** The cells that become bricks. */
enum class Fill
{
    SURFACE, //!< the covered cells
    SHELL,   //!< and the interior cells within LegoSettings::Parts::shell cells of the outside
    SOLID    //!< and all interior cells
};

/** The parts that cells are joined to. */
enum class PartSet
{
    NONE,  //!< every cell is a separate brick
    BRICKS //!< real bricks of 1x1 to 2x8 studs, and plates in a grid of Proportions::PLATE
};

/** The work spent on a layout of parts: limits of counts, not of time, so that layouts don't depend on the machine. */
enum class Effort
{
    INSTANT, //!< little enough for a source that moves
    NORMAL,  //!< enough for few parts
    BEST     //!< the most, for the fewest parts
};

/** The colours in which parts are shown. */
enum class Show
{
    COLOR, //!< their own
    LOAD   //!< a scale from blue to red: the load on their joints, as a share of the capacity (StabilityReport::loads)
};

/** The settings that determine the bricks of a mesh and how they are drawn, and their text form.
 *
 * A plain value: copy it, change members, and pass it to LegoNode::setSettings() or legolizeOnCpu(), which check it.
 *
 * The text form is a list of `key=value` separated by commas; a number alone is the resolution:
 *
 *     64
 *     64,proportions=plate,up=y
 *     resolution=128,method=points,target=projected,fbo=1024
 *     cell=0.15,origin=0:0:0.5,size=64:64:32
 *
 * describe() lists the keys, and docs/settings.md explains them.
 *
 * Parts need `proportions=brick` or `plate`: `parts=bricks` in a text without proportions selects `brick`.
 *
 * Usage:
 *
 *     osgLego::LegoSettings settings;
 *     std::string error;
 *     if (!osgLego::LegoSettings::parse("64,proportions=plate", settings, error)) std::cerr << error << '\n';
 *
 * Every function may be called from any thread on an object that no other thread is changing.
 */
struct OSGLEGO_EXPORT LegoSettings
{
    static constexpr unsigned int MAXIMUM_RESOLUTION = GridLimits::MOST_CELLS;
    static constexpr double MINIMUM_CELL = 1e-9;
    static constexpr double MAXIMUM_CELL = 1e12;
    static constexpr double MAXIMUM_ORIGIN = 1e18; //!< of either sign
    static constexpr unsigned int MINIMUM_FBO_SIZE = 16;
    static constexpr unsigned int MAXIMUM_FBO_SIZE = 8192;
    static constexpr double MINIMUM_EDGE_LIMIT = 0.0625;
    static constexpr double MAXIMUM_EDGE_LIMIT = 4.0;
    static constexpr unsigned int MAXIMUM_COLORS = 255;
    static constexpr unsigned int MAXIMUM_SHELL = 1024;

    /** The lattice of cells. */
    struct Grid
    {
        /** The longest side of the source's bounds in widths of a cell, 1 to MAXIMUM_RESOLUTION ("N" in the paper); the
         * default if there is a `cellPitch`. */
        unsigned int resolution = 64;
        /** The width of a cell in model units, MINIMUM_CELL to MAXIMUM_CELL; its height follows from the proportions.
         * Unset: the resolution determines it. */
        std::optional<double> cellPitch;
        /** A corner of a cell in model units, each coordinate at most MAXIMUM_ORIGIN: the cells of all nodes with equal
         * pitch, proportions, up axis and origin belong to one lattice. Needs a `cellPitch`. Unset: the model's origin.
         */
        std::optional<glm::dvec3> origin;
        /** The number of cells along the model's x, y and z, from `origin` on, which it needs: each at least 1, and
         * within GridLimits. Geometry outside is ignored. Unset: all cells that the model reaches. */
        std::optional<glm::ivec3> size;
        Proportions proportions = Proportions::CUBE;
        UpAxis upAxis = UpAxis::Z;
        /** With FIRST, MODEL and WORLD, the first source determines the width of a cell by the resolution, and later
         * ones have cells of the same lattice, until settings that give other bricks are set. With WORLD, `cellPitch`,
         * `origin`, `size` and the up axis are those of the world. FIRST can't be combined with a `cellPitch`. */
        Anchor anchor = Anchor::FIT;

        bool operator==(const Grid&) const = default;
    };

    /** How covered cells are found. */
    struct Voxelization
    {
        VoxelizationMethod method = VoxelizationMethod::EXACT;
        /** Unset: the method's default; see getTarget(). */
        std::optional<VoxelizationTarget> target;
        /** Pixels along a side of a projected target, MINIMUM_FBO_SIZE to MAXIMUM_FBO_SIZE; other targets ignore it. */
        unsigned int fboSize = 1024;
        /** The longest edge that subdivision leaves, in cells, MINIMUM_EDGE_LIMIT to MAXIMUM_EDGE_LIMIT; unset: the
         * method's default, see getEdgeLimit(). */
        std::optional<double> edgeLimit;
        /** Both devices find the same cells, except cells that a triangle merely grazes; colours may differ by
         * rounding. */
        Device device = Device::AUTO;

        bool operator==(const Voxelization&) const = default;
    };

    /** The colours of bricks. */
    struct Colors
    {
        /** "none" (any colour), "ldraw" or the path of a file (see Palette::read()), without commas, brackets and
         * surrounding spaces. Unset: see getPalette(). */
        std::optional<std::string> palette;
        /** The number of colours, 1 to MAXIMUM_COLORS: those of the palette that suit the source best. Unset: all. */
        std::optional<unsigned int> count;
        /** Whether colours between those of the palette are imitated by a pattern of cells. */
        bool dither = false;

        bool operator==(const Colors&) const = default;
    };

    /** The cells that become bricks, and the parts that they are joined to. */
    struct Parts
    {
        Fill fill = Fill::SURFACE;
        /** The thickness of Fill::SHELL in cells, 1 to MAXIMUM_SHELL; 1 is the surface alone. */
        unsigned int shell = 2;
        /** Parts are laid on the CPU, and need VoxelizationMethod::EXACT and bricks or plates as cells. */
        PartSet set = PartSet::NONE;
        /** The start of the layout's random numbers: equal seeds give equal parts of equal cells. A LegoNode whose
         * source has moved also keeps parts of the layout before; legolizeOnCpu() does not. */
        std::uint32_t seed = 0;
        Effort effort = Effort::NORMAL;
        /** Whether the pieces of a model of parts are joined to one, by cells in other colours and additional cells. */
        bool connect = false;
        /** Whether a falling model of parts is changed so that it stands: its pieces are joined, its parts are laid
         * again and, if that does not suffice, hidden cells and columns are added. Columns are also added below a
         * model that stands, if its BuildingPlan then exceeds the limits less. */
        bool support = false;

        bool operator==(const Parts&) const = default;
    };

    /** How bricks are shown; these settings do not affect which bricks there are. */
    struct View
    {
        Look look = Look::FULL;
        Drawing drawing = Drawing::AUTO;
        /** The share of parts that is shown, 0 to 1, in the order of building (LegoNode::setBuildProgress()). */
        double progress = 1.0;
        Show show = Show::COLOR;
        /** The picture until the first bricks of a LegoNode are ready. */
        Meanwhile meanwhile = Meanwhile::WAIT;

        bool operator==(const View&) const = default;
    };

    Grid grid;
    Voxelization voxelization;
    Colors colors;
    Parts parts;
    View view;

    /** The target in effect: `voxelization.target` if set, otherwise the method's default (points: projected, exact:
     * addressed). */
    VoxelizationTarget getTarget() const;
    /** The edge limit in effect, in cells: `voxelization.edgeLimit` if set, otherwise the method's default (points: 1,
     * as in the paper; exact: 2). */
    double getEdgeLimit() const;
    /** The palette in effect: `colors.palette` if set, otherwise "ldraw" with parts and "none" without. */
    std::string getPalette() const;
    /** Whether cells are filled or joined to parts, which only the CPU does. */
    bool needsCpu() const;
    /** The height of a cell, divided by its width: 1, 1.2 or 0.4. */
    double getCellHeight() const;

    /** Check these values.
     * @return one sentence that names the first bad value and the expected values; empty if all values are good. */
    std::string check() const;

    /** Read the text form.
     *
     * Keys that are not in the text keep the values that `settings` had, except that a resolution replaces cell, origin
     * and size, and a cell replaces the resolution.
     * @return false, with one sentence in `error` and `settings` unchanged, for an unknown key, a bad value, a key
     * given twice, or a combination of values that check() rejects. */
    static bool parse(const std::string& text, LegoSettings& settings, std::string& error);

    /** All keys of the text form, in its order. */
    static const SettingDescriptions& describe();

    /** The shortest text that parse() turns into these values; it begins with the resolution, or with the pitch of a
     * cell. */
    std::string toString() const;

    /** Whether a mesh gets the same bricks from both settings: all groups but the view are equal. */
    bool givesSameBricks(const LegoSettings& other) const;

    bool operator==(const LegoSettings&) const = default;
};

} // namespace osgLego
