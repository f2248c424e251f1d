#include <osgLego/LegoSettings.h>

#include <osgLego/text/SettingValues.h>
#include <osgLego/text/SettingsTable.h>

#include <limits>
#include <string_view>
#include <vector>

namespace osgLego
{

namespace
{

/** Names of palettes that the text form can hold. */
class PaletteName
{
public:
    static constexpr SettingType TYPE = SettingType::FILE;

    std::vector<std::string> getChoices() const { return {"none", "ldraw"}; }
    std::string getForm() const { return joinTexts(getChoices(), "|", "|") + "|<file>"; }
    std::string getValues() const { return joinTexts(getChoices(), ", ", ", ") + " or a file"; }
    std::string getExpected() const
    {
        return joinTexts(getChoices(), ", ", ", ") +
               " or the path of a file, without commas, brackets and surrounding spaces";
    }
    bool read(std::string_view text, std::string& palette) const
    {
        palette = text;
        return true;
    }
    std::string write(const std::string& palette) const { return palette; }
    bool contains(std::string_view palette) const
    {
        return !palette.empty() && palette == trimmed(palette) &&
               palette.find_first_of(",()[]") == std::string_view::npos;
    }
};

class GridOrigin : public ThreeNumbers<glm::dvec3>
{
public:
    SettingRange getRange() const { return {-LegoSettings::MAXIMUM_ORIGIN, LegoSettings::MAXIMUM_ORIGIN}; }
    std::string getForm() const { return "<x>:<y>:<z>"; }
    std::string getValues() const { return "x:y:z in model units, each " + limitsOf<double>(getRange()); }
    std::string getExpected() const { return getValues(); }
    bool contains(const glm::dvec3& origin) const
    {
        const SettingRange range = getRange();
        return range.contains(origin.x) && range.contains(origin.y) && range.contains(origin.z);
    }
};

class GridSize : public ThreeNumbers<glm::ivec3>
{
public:
    SettingRange getRange() const { return {1.0, static_cast<double>(GridLimits::MOST_LAYERS)}; }
    std::string getForm() const { return "<w>:<d>:<h>"; }
    std::string getValues() const
    {
        const SettingRange sideways{getRange().minimum, static_cast<double>(GridLimits::MOST_CELLS)};
        return "w:d:h in cells, each " + limitsOf<int>(sideways) + ", and up to " + toText(GridLimits::MOST_LAYERS) +
               " along the up axis";
    }
    std::string getExpected() const { return getValues(); }
    bool contains(const glm::ivec3& size, const LegoSettings& settings) const
    {
        return glm::all(glm::greaterThanEqual(size, glm::ivec3(1))) &&
               GridLimits::contain(size, settings.grid.upAxis == UpAxis::Y ? 1 : 2);
    }
};

using Table = SettingsTable<LegoSettings>;

void addGrid(Table& table)
{
    using Grid = LegoSettings::Grid;
    SettingsGroup grid(table, "grid", &LegoSettings::grid);
    grid.add("resolution", &Grid::resolution, NumberRange(1u, LegoSettings::MAXIMUM_RESOLUTION),
             "widths of a cell along the longest side of the model");
    grid.add("cell", &Grid::cellPitch,
             NumberRange(LegoSettings::MINIMUM_CELL, LegoSettings::MAXIMUM_CELL, "model units"),
             "width of a cell, instead of a resolution", "none");
    grid.add("origin", &Grid::origin, GridOrigin(), "a corner of a cell; needs cell", "0:0:0");
    grid.add("size", &Grid::size, GridSize(), "cells along the model's x, y and z, from the origin on; needs origin",
             "as large as the model");
    grid.add(
        "proportions", &Grid::proportions,
        Choice<Proportions>{{"cube", Proportions::CUBE}, {"brick", Proportions::BRICK}, {"plate", Proportions::PLATE}},
        "height of a cell divided by its width, which is 1, 1.2 or 0.4");
    grid.add("up", &Grid::upAxis, Choice<UpAxis>{{"y", UpAxis::Y}, {"z", UpAxis::Z}},
             "the axis of the model along which studs point");
    grid.add("anchor", &Grid::anchor,
             Choice<Anchor>{
                 {"fit", Anchor::FIT}, {"first", Anchor::FIRST}, {"model", Anchor::MODEL}, {"world", Anchor::WORLD}},
             "the lattice of a moving model's cells");
}

void addVoxelization(Table& table)
{
    using Method = VoxelizationMethod;
    using Target = VoxelizationTarget;
    using Voxelization = LegoSettings::Voxelization;
    SettingsGroup voxelization(table, "voxelization", &LegoSettings::voxelization);
    voxelization.add("method", &Voxelization::method,
                     Choice<Method>{{"points", Method::POINTS}, {"exact", Method::EXACT}},
                     "how covered cells are found");
    voxelization.add("target", &Voxelization::target,
                     Choice<Target>{{"projected", Target::PROJECTED}, {"addressed", Target::ADDRESSED}},
                     "where points are drawn, either into a picture of the model or each into the pixel of its cell",
                     "addressed; projected with method=points");
    voxelization.add("fbo", &Voxelization::fboSize,
                     NumberRange(LegoSettings::MINIMUM_FBO_SIZE, LegoSettings::MAXIMUM_FBO_SIZE, "pixels"),
                     "side of a projected target");
    voxelization.add("edge", &Voxelization::edgeLimit,
                     NumberRange(LegoSettings::MINIMUM_EDGE_LIMIT, LegoSettings::MAXIMUM_EDGE_LIMIT, "cells"),
                     "longest edge of a triangle after subdivision", "2; 1 with method=points");
    voxelization.add("device", &Voxelization::device,
                     Choice<Device>{{"auto", Device::AUTO}, {"gpu", Device::GPU}, {"cpu", Device::CPU}},
                     "the processor that finds the bricks; cpu needs method=exact");
}

void addColors(Table& table)
{
    using Colors = LegoSettings::Colors;
    SettingsGroup colors(table, "colors", &LegoSettings::colors);
    colors.add("palette", &Colors::palette, PaletteName(), "the colours that bricks may have",
               "none; ldraw with parts");
    colors.add("colors", &Colors::count, NumberRange(1u, LegoSettings::MAXIMUM_COLORS),
               "the number of colours, those of the palette that suit the model best", "all of the palette");
    colors.add("dither", &Colors::dither, Switch(), "imitate other colours by a pattern of cells");
}

void addParts(Table& table)
{
    using Parts = LegoSettings::Parts;
    SettingsGroup parts(table, "parts", &LegoSettings::parts);
    parts.add("fill", &Parts::fill,
              Choice<Fill>{{"surface", Fill::SURFACE}, {"shell", Fill::SHELL}, {"solid", Fill::SOLID}},
              "the cells that become bricks, either covered ones alone or interior ones, too");
    parts.add("shell", &Parts::shell, NumberRange(1u, LegoSettings::MAXIMUM_SHELL, "cells"), "thickness of fill=shell");
    parts.add("parts", &Parts::set, Choice<PartSet>{{"none", PartSet::NONE}, {"bricks", PartSet::BRICKS}},
              "one brick for each cell, or real bricks and plates");
    parts.add("seed", &Parts::seed, NumberRange<std::uint32_t>(0, std::numeric_limits<std::uint32_t>::max()),
              "the start of the layout's random numbers; each gives another layout");
    parts.add("effort", &Parts::effort,
              Choice<Effort>{{"instant", Effort::INSTANT}, {"normal", Effort::NORMAL}, {"best", Effort::BEST}},
              "the work spent on the layout");
    parts.add("connect", &Parts::connect, Switch(), "join the pieces of a model of parts to one");
    parts.add("support", &Parts::support, Switch(), "change a falling model of parts so that it stands");
}

void addView(Table& table)
{
    using View = LegoSettings::View;
    SettingsGroup view(table, "view", &LegoSettings::view);
    view.add("look", &View::look, Choice<Look>{{"plain", Look::PLAIN}, {"full", Look::FULL}},
             "smooth bricks lit by Phong's model, or plastic ones");
    view.add("drawing", &View::drawing,
             Choice<Drawing>{{"auto", Drawing::AUTO}, {"triangles", Drawing::TRIANGLES}, {"splats", Drawing::SPLATS}},
             "how bricks are drawn");
    view.add("progress", &View::progress, NumberRange(0.0, 1.0),
             "the share of parts that is shown, in the order of building");
    view.add("show", &View::show, Choice<Show>{{"color", Show::COLOR}, {"load", Show::LOAD}},
             "parts in their colours, or in colours for the load on their joints");
    view.add(
        "meanwhile", &View::meanwhile,
        Choice<Meanwhile>{{"wait", Meanwhile::WAIT},
                          {"draft", Meanwhile::DRAFT},
                          {"source", Meanwhile::SOURCE},
                          {"nothing", Meanwhile::NOTHING}},
        "until the first bricks are ready, the frame waits, or shows a draft of their parts, the source or nothing");
}

/** All keys. A setting is added here, and as a member in the header. */
const Table& getTable()
{
    static const Table table = []
    {
        Table created;
        addGrid(created);
        addVoxelization(created);
        addColors(created);
        addParts(created);
        addView(created);
        return created;
    }();
    return table;
}

/** Reads the settings of a text, in which either a resolution or cell, origin and size may describe the grid, and parts
 * are bricks unless the text gives other proportions. */
class SettingReader
{
public:
    std::string operator()(std::string_view key, std::string_view value, LegoSettings& settings)
    {
        LegoSettings::Grid& grid = settings.grid;
        const bool isResolution = key == "resolution";
        const bool isCells = key == "cell" || key == "origin" || key == "size";
        if (isResolution ? _hasCells : isCells && _hasResolution)
            return "a resolution can't be combined with cell, origin or size; expected either";
        if (isResolution)
        {
            _hasResolution = true;
            grid.cellPitch.reset();
            grid.origin.reset();
            grid.size.reset();
        }
        if (isCells) _hasCells = true;
        if (key == "cell") grid.resolution = LegoSettings::Grid().resolution;
        if (key == "proportions") _hasProportions = true;
        std::string error = getTable().read(key, value, settings);
        const bool isCube = grid.proportions == Proportions::CUBE;
        if (settings.parts.set != PartSet::NONE && isCube && !_hasProportions) grid.proportions = Proportions::BRICK;
        return error;
    }

private:
    bool _hasResolution = false;
    bool _hasCells = false;
    bool _hasProportions = false;
};

/** @return the first error in the combination of settings of the grid, in one sentence; empty if there is none. */
std::string checkGrid(const LegoSettings::Grid& grid)
{
    if (grid.origin && !grid.cellPitch) return "origin is given without cell; expected both";
    if (grid.size && !grid.origin) return "size is given without origin; expected both, and cell";
    if (grid.cellPitch && grid.resolution != LegoSettings::Grid().resolution)
        return "a resolution can't be combined with cell; expected either";
    if (grid.anchor == Anchor::FIRST && grid.cellPitch)
        return "bad value 'first' for anchor; expected fit, model or world with cell";
    return {};
}

/** The same for voxelization. */
std::string checkVoxelization(const LegoSettings& settings)
{
    const VoxelizationMethod method = settings.voxelization.method;
    if (method == VoxelizationMethod::EXACT && settings.getTarget() != VoxelizationTarget::ADDRESSED)
        return "bad value 'projected' for target; expected addressed with method=exact";
    if (method == VoxelizationMethod::POINTS && settings.voxelization.device == Device::CPU)
        return "bad value 'cpu' for device; expected auto or gpu with method=points";
    return {};
}

/** The same for colours, cells to fill and parts. */
std::string checkParts(const LegoSettings& settings)
{
    if (settings.getPalette() == "none" && settings.colors.count)
        return "colors is given without a palette; expected palette=ldraw or a file";
    if (settings.getPalette() == "none" && settings.colors.dither)
        return "dither is on without a palette; expected palette=ldraw or a file";
    if (settings.parts.set != PartSet::NONE && settings.grid.proportions == Proportions::CUBE)
        return "bad value 'cube' for proportions; expected brick or plate with parts";
    if (settings.parts.connect && settings.parts.set == PartSet::NONE)
        return "connect is on without parts; expected parts=bricks";
    if (settings.parts.support && settings.parts.set == PartSet::NONE)
        return "support is on without parts; expected parts=bricks";
    const LegoSettings::Voxelization& voxelization = settings.voxelization;
    if (settings.needsCpu() && (voxelization.method != VoxelizationMethod::EXACT || voxelization.device == Device::GPU))
        return "parts, and fill other than surface, are made on the CPU; expected method=exact, and device=auto or cpu";
    return {};
}

} // namespace

VoxelizationTarget LegoSettings::getTarget() const
{
    if (voxelization.target) return *voxelization.target;
    return voxelization.method == VoxelizationMethod::POINTS ? VoxelizationTarget::PROJECTED
                                                             : VoxelizationTarget::ADDRESSED;
}

double LegoSettings::getEdgeLimit() const
{
    if (voxelization.edgeLimit) return *voxelization.edgeLimit;
    return voxelization.method == VoxelizationMethod::POINTS ? 1.0 : 2.0;
}

std::string LegoSettings::getPalette() const
{
    if (colors.palette) return *colors.palette;
    return parts.set == PartSet::NONE ? "none" : "ldraw";
}

bool LegoSettings::needsCpu() const
{
    return parts.set != PartSet::NONE || parts.fill != Fill::SURFACE;
}

double LegoSettings::getCellHeight() const
{
    switch (grid.proportions)
    {
    case Proportions::BRICK:
        return 1.2;
    case Proportions::PLATE:
        return 0.4;
    case Proportions::CUBE:
        break;
    }
    return 1.0;
}

std::string LegoSettings::check() const
{
    if (std::string error = getTable().check(*this); !error.empty()) return error;
    if (std::string error = checkGrid(grid); !error.empty()) return error;
    if (std::string error = checkVoxelization(*this); !error.empty()) return error;
    return checkParts(*this);
}

const SettingDescriptions& LegoSettings::describe()
{
    return getTable().describe();
}

bool LegoSettings::givesSameBricks(const LegoSettings& other) const
{
    LegoSettings alike = other;
    alike.view = view;
    return alike == *this;
}

bool LegoSettings::parse(const std::string& text, LegoSettings& settings, std::string& error)
{
    // Brackets belong to the name of a `.legolize` file, from which they are easily copied.
    if (const auto bracket = text.find_first_of("()[]"); bracket != std::string::npos)
    {
        error = std::string("unexpected '") + text[bracket] + "' as character " + std::to_string(bracket + 1) +
                " of '" + text + "'; expected settings without brackets, such as 64,up=y";
        return false;
    }
    return parseSettings(text, describe(), isWholeNumber, SettingReader(), settings, error);
}

std::string LegoSettings::toString() const
{
    return getTable().write(*this, !grid.cellPitch);
}

} // namespace osgLego
