#pragma once

#include <osgLego/Export.h>

#include <optional>
#include <string>

namespace osgLego
{

/** The shape of a cell: its height over its width. */
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

/** Which samples of a triangle mark cells as covered. */
enum class VoxelizationMethod
{
    POINTS, //!< the vertices of the subdivided triangles, one point each (the paper, section III-B)
    EXACT   //!< every cell whose box a triangle overlaps (Akenine-Moller's separating-axis test), no other
};

/** What a texel of the voxelization's frame buffer object stands for. */
enum class VoxelizationTarget
{
    PROJECTED, //!< a pixel of an orthographic picture of the mesh (the paper, Algorithms 3 and 4)
    ADDRESSED  //!< one cell of the grid (the paper's future work)
};

/** What finds the bricks. */
enum class Device
{
    AUTO, //!< the CPU where a software renderer draws and the method is EXACT, else the GPU
    GPU,  //!< the passes of the method
    CPU   //!< legolizeOnCpu, for EXACT alone
};

/** How bricks are drawn. */
enum class Look
{
    PLAIN, //!< smooth bricks by Phong's model, in the light of the scene's lights alone
    FULL   //!< plastic with joints and relief (BrickAppearance), in the light of a probe besides (LightProbe)
};

/** By which means bricks are drawn; the picture is the same. */
enum class Drawing
{
    AUTO,      //!< splats where a software renderer draws, else triangles
    TRIANGLES, //!< triangles out of a geometry shader
    SPLATS     //!< points whose pixels cast rays; triangles where rays can't show the bricks, as when they are cut open
};

/** Everything that decides which bricks stand for a mesh, and whether they look like bricks; and the one text form of
 * it.
 *
 * A plain value: copy it, change members, hand it to LegoNode::setSettings or legolizeOnCpu, which check it.
 *
 * The text form is a list of `key=value` separated by commas; a number alone is the resolution:
 *
 *     64
 *     64,proportions=plate,up=y
 *     resolution=128,method=points,target=projected,fbo=1024
 *
 * | key         | values                                     | default                             |
 * |-------------|--------------------------------------------|-------------------------------------|
 * | resolution  | 1 to 1024                                  | 64                                  |
 * | proportions | cube, brick, plate                         | cube                                |
 * | up          | y, z                                       | z                                   |
 * | method      | points, exact                              | exact                               |
 * | target      | projected, addressed (exact: addressed)    | projected (points), addressed (exact) |
 * | fbo         | 16 to 8192, the side of a projected target | 1024                                |
 * | edge        | 0.0625 to 4                                | 1 (points), 2 (exact)               |
 * | device      | auto, gpu, cpu (points: auto, gpu)         | auto                                |
 * | look        | plain, full                                | full                                |
 * | drawing     | auto, triangles, splats                    | auto                                |
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
    static constexpr unsigned int MAXIMUM_RESOLUTION = 1024;
    static constexpr unsigned int MINIMUM_FBO_SIZE = 16;
    static constexpr unsigned int MAXIMUM_FBO_SIZE = 8192;
    static constexpr double MINIMUM_EDGE_LIMIT = 0.0625;
    static constexpr double MAXIMUM_EDGE_LIMIT = 4.0;

    /** Cells along the longest side of the source's bounds, 1 to MAXIMUM_RESOLUTION ("N" in the paper). */
    unsigned int resolution = 64;
    Proportions proportions = Proportions::CUBE;
    UpAxis upAxis = UpAxis::Z;
    VoxelizationMethod method = VoxelizationMethod::EXACT;
    /** Unset: what getTarget() answers. */
    std::optional<VoxelizationTarget> target;
    /** Pixels along a side of a projected target, MINIMUM_FBO_SIZE to MAXIMUM_FBO_SIZE; other targets ignore it. */
    unsigned int fboSize = 1024;
    /** The longest edge that subdivision leaves, in cells; unset: what getEdgeLimit() answers. */
    std::optional<double> edgeLimit;
    /** Both find the same cells; colours may differ by what rounding does. */
    Device device = Device::AUTO;
    // These two have no effect on which bricks there are.
    Look look = Look::FULL;
    Drawing drawing = Drawing::AUTO;

    /** The target in force: `target`, or the method's own (points: projected, exact: addressed). */
    VoxelizationTarget getTarget() const;
    /** The edge limit in force, in cells: `edgeLimit`, or the method's own (points: 1, the paper's; exact: 2). */
    double getEdgeLimit() const;
    /** The height of a cell over its width: 1, 1.2 or 0.4. */
    double getCellHeight() const;

    /** What is wrong with these values and what is allowed instead, in one sentence; empty when nothing is. */
    std::string check() const;

    /** Read the text form.
     *
     * Keys that the text does not name keep the values that `settings` had.
     * @return false, with one sentence in `error` and `settings` unchanged, on an unknown key, a bad value, a key
     * given twice, or values that check() refuses together. */
    static bool parse(const std::string& text, LegoSettings& settings, std::string& error);

    /** Whether the text form has a key of that name. */
    static bool isKey(const std::string& name);

    /** The shortest text that parse() turns into these values, beginning with the resolution. */
    std::string toString() const;

    /** Whether the same mesh gives the same bricks: equal in everything but the look and the drawing. */
    bool givesSameBricks(const LegoSettings& other) const;

    bool operator==(const LegoSettings&) const = default;
};

} // namespace osgLego
