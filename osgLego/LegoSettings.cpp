#include <osgLego/LegoSettings.h>

#include <osgLego/data/SettingsText.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string_view>

namespace osgLego
{

namespace
{

constexpr std::array PROPORTIONS_NAMES{SettingName<Proportions>{"cube", Proportions::CUBE},
                                       SettingName<Proportions>{"brick", Proportions::BRICK},
                                       SettingName<Proportions>{"plate", Proportions::PLATE}};
constexpr std::array UP_NAMES{SettingName<UpAxis>{"y", UpAxis::Y}, SettingName<UpAxis>{"z", UpAxis::Z}};
constexpr std::array METHOD_NAMES{SettingName<VoxelizationMethod>{"points", VoxelizationMethod::POINTS},
                                  SettingName<VoxelizationMethod>{"exact", VoxelizationMethod::EXACT}};
constexpr std::array TARGET_NAMES{SettingName<VoxelizationTarget>{"projected", VoxelizationTarget::PROJECTED},
                                  SettingName<VoxelizationTarget>{"addressed", VoxelizationTarget::ADDRESSED}};
constexpr std::array DEVICE_NAMES{SettingName<Device>{"auto", Device::AUTO}, SettingName<Device>{"gpu", Device::GPU},
                                  SettingName<Device>{"cpu", Device::CPU}};
constexpr std::array LOOK_NAMES{SettingName<Look>{"plain", Look::PLAIN}, SettingName<Look>{"full", Look::FULL}};
constexpr std::array DRAWING_NAMES{SettingName<Drawing>{"auto", Drawing::AUTO},
                                   SettingName<Drawing>{"triangles", Drawing::TRIANGLES},
                                   SettingName<Drawing>{"splats", Drawing::SPLATS}};
constexpr std::array FILL_NAMES{SettingName<Fill>{"surface", Fill::SURFACE}, SettingName<Fill>{"shell", Fill::SHELL},
                                SettingName<Fill>{"solid", Fill::SOLID}};
constexpr std::array PARTS_NAMES{SettingName<PartSet>{"none", PartSet::NONE},
                                 SettingName<PartSet>{"bricks", PartSet::BRICKS}};
constexpr std::array EFFORT_NAMES{SettingName<Effort>{"instant", Effort::INSTANT},
                                  SettingName<Effort>{"normal", Effort::NORMAL},
                                  SettingName<Effort>{"best", Effort::BEST}};
constexpr std::array SHOW_NAMES{SettingName<Show>{"color", Show::COLOR}, SettingName<Show>{"load", Show::LOAD}};
constexpr std::array SWITCH_NAMES{SettingName<bool>{"off", false}, SettingName<bool>{"on", true}};
constexpr std::string_view KEYS = "resolution, cell, origin, size, proportions, up, method, target, fbo, edge, device, "
                                  "palette, colors, dither, fill, shell, parts, seed, effort, support, look, drawing, "
                                  "progress, show";

constexpr const char* EXPECTED_CELL = "a number of model units, 1e-9 to 1e+12";
constexpr const char* EXPECTED_ORIGIN = "x:y:z in model units, each -1e+18 to 1e+18";
constexpr const char* EXPECTED_PALETTE = "none, ldraw or the path of a file, without commas, brackets and "
                                         "surrounding spaces";
constexpr const char* EXPECTED_COLORS = "a whole number, 1 to 255";
constexpr const char* EXPECTED_SHELL = "a whole number of cells, 1 to 1024";
constexpr const char* EXPECTED_PROGRESS = "a number, 0 to 1";
constexpr const char* EXPECTED_SIZE = "w:d:h in cells, each 1 to 1024, and up to 2560 along the up axis";

bool isNumber(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/** Read one value. @return what is wrong with it; empty when nothing is. */
std::string readSetting(std::string_view key, std::string_view value, LegoSettings& settings)
{
    if (key == "resolution") return readNumber(key, value, "a whole number, 1 to 1024", settings.grid.resolution);
    if (key == "cell") return readNumber(key, value, EXPECTED_CELL, settings.grid.cellPitch.emplace());
    if (key == "origin") return readVector(key, value, EXPECTED_ORIGIN, settings.grid.origin.emplace());
    if (key == "size") return readVector(key, value, EXPECTED_SIZE, settings.grid.size.emplace());
    if (key == "proportions") return readName(key, value, PROPORTIONS_NAMES, settings.grid.proportions);
    if (key == "up") return readName(key, value, UP_NAMES, settings.grid.upAxis);
    if (key == "method") return readName(key, value, METHOD_NAMES, settings.voxelization.method);
    if (key == "target") return readName(key, value, TARGET_NAMES, settings.voxelization.target.emplace());
    if (key == "fbo")
        return readNumber(key, value, "a whole number of pixels, 16 to 8192", settings.voxelization.fboSize);
    if (key == "edge")
        return readNumber(key, value, "a number of cells, 0.0625 to 4", settings.voxelization.edgeLimit.emplace());
    if (key == "device") return readName(key, value, DEVICE_NAMES, settings.voxelization.device);
    if (key == "palette")
    {
        settings.colors.palette.emplace(value);
        return {};
    }
    if (key == "colors") return readNumber(key, value, EXPECTED_COLORS, settings.colors.count.emplace());
    if (key == "dither") return readName(key, value, SWITCH_NAMES, settings.colors.dither);
    if (key == "fill") return readName(key, value, FILL_NAMES, settings.parts.fill);
    if (key == "shell") return readNumber(key, value, EXPECTED_SHELL, settings.parts.shell);
    if (key == "parts") return readName(key, value, PARTS_NAMES, settings.parts.set);
    if (key == "seed") return readNumber(key, value, "a whole number, 0 to 4294967295", settings.parts.seed);
    if (key == "effort") return readName(key, value, EFFORT_NAMES, settings.parts.effort);
    if (key == "support") return readName(key, value, SWITCH_NAMES, settings.parts.support);
    if (key == "look") return readName(key, value, LOOK_NAMES, settings.view.look);
    if (key == "drawing") return readName(key, value, DRAWING_NAMES, settings.view.drawing);
    if (key == "progress") return readNumber(key, value, EXPECTED_PROGRESS, settings.view.progress);
    if (key == "show") return readName(key, value, SHOW_NAMES, settings.view.show);
    return unknownKey(key, KEYS);
}

/** Reads the settings of a text, in which either a resolution or cell, origin and size may describe the grid, and parts
 * are bricks unless the text gives other proportions. */
class SettingReader
{
public:
    std::string operator()(std::string_view key, std::string_view value, LegoSettings& settings)
    {
        const bool isResolution = key == "resolution";
        const bool isCells = key == "cell" || key == "origin" || key == "size";
        if (isResolution ? _hasCells : isCells && _hasResolution)
            return "a resolution can't be combined with cell, origin or size; expected either";
        if (isResolution)
        {
            _hasResolution = true;
            settings.grid.cellPitch.reset();
            settings.grid.origin.reset();
            settings.grid.size.reset();
        }
        if (isCells) _hasCells = true;
        if (key == "cell") settings.grid.resolution = LegoSettings().grid.resolution;
        if (key == "proportions") _hasProportions = true;
        std::string error = readSetting(key, value, settings);
        const bool isCube = settings.grid.proportions == Proportions::CUBE;
        if (settings.parts.set != PartSet::NONE && isCube && !_hasProportions)
            settings.grid.proportions = Proportions::BRICK;
        return error;
    }

private:
    bool _hasResolution = false;
    bool _hasCells = false;
    bool _hasProportions = false;
};

template <typename Number>
std::string rangeError(const char* key, Number value, const char* unit, Number minimum, Number maximum)
{
    return badValue(key, toText(value), std::string(unit) + ", " + toText(minimum) + " to " + toText(maximum));
}

template <typename Vector>
std::string vectorToText(const Vector& vector)
{
    return toText(vector.x) + ":" + toText(vector.y) + ":" + toText(vector.z);
}

bool isInRange(const glm::dvec3& origin)
{
    const auto isGood = [](double coordinate) { return std::abs(coordinate) <= LegoSettings::MAXIMUM_ORIGIN; };
    return isGood(origin.x) && isGood(origin.y) && isGood(origin.z);
}

bool isInRange(const glm::ivec3& size, UpAxis upAxis)
{
    const int up = upAxis == UpAxis::Y ? 1 : 2;
    for (int axis = 0; axis < 3; ++axis)
    {
        const int most = axis == up ? LegoSettings::MAXIMUM_LAYERS : static_cast<int>(LegoSettings::MAXIMUM_RESOLUTION);
        if (size[axis] < 1 || size[axis] > most) return false;
    }
    return true;
}

/** @return the first error in the settings of the lattice, in one sentence; empty if there is none. */
std::string checkLattice(const LegoSettings& settings)
{
    if (settings.grid.origin && !settings.grid.cellPitch) return "origin is given without cell; expected both";
    if (settings.grid.size && !settings.grid.origin) return "size is given without origin; expected both, and cell";
    if (!settings.grid.cellPitch) return {};
    if (settings.grid.resolution != LegoSettings().grid.resolution)
        return "a resolution can't be combined with cell; expected either";
    const double pitch = *settings.grid.cellPitch;
    if (!(pitch >= LegoSettings::MINIMUM_CELL && pitch <= LegoSettings::MAXIMUM_CELL))
        return badValue("cell", toText(pitch), EXPECTED_CELL);
    if (settings.grid.origin && !isInRange(*settings.grid.origin))
        return badValue("origin", vectorToText(*settings.grid.origin), EXPECTED_ORIGIN);
    if (settings.grid.size && !isInRange(*settings.grid.size, settings.grid.upAxis))
        return badValue("size", vectorToText(*settings.grid.size), EXPECTED_SIZE);
    return {};
}

/** Whether parse() returns this name of a palette from the text form. */
bool isInTextForm(std::string_view palette)
{
    constexpr std::string_view SPACE = " \t\r\n";
    if (palette.empty() || palette.find_first_of(",()[]") != std::string_view::npos) return false;
    return SPACE.find(palette.front()) == std::string_view::npos &&
           SPACE.find(palette.back()) == std::string_view::npos;
}

/** @return the first error in the settings of colours, cells to fill and parts, in one sentence; empty if there is
 * none. */
std::string checkParts(const LegoSettings& settings)
{
    if (settings.colors.palette && !isInTextForm(*settings.colors.palette))
        return badValue("palette", *settings.colors.palette, EXPECTED_PALETTE);
    if (settings.colors.count && (*settings.colors.count < 1 || *settings.colors.count > LegoSettings::MAXIMUM_COLORS))
        return badValue("colors", toText(*settings.colors.count), EXPECTED_COLORS);
    if (settings.parts.shell < 1 || settings.parts.shell > LegoSettings::MAXIMUM_SHELL)
        return badValue("shell", toText(settings.parts.shell), EXPECTED_SHELL);
    if (settings.getPalette() == "none" && settings.colors.count)
        return "colors is given without a palette; expected palette=ldraw or a file";
    if (settings.getPalette() == "none" && settings.colors.dither)
        return "dither is on without a palette; expected palette=ldraw or a file";
    if (settings.parts.set != PartSet::NONE && settings.grid.proportions == Proportions::CUBE)
        return "bad value 'cube' for proportions; expected brick or plate with parts";
    if (settings.parts.support && settings.parts.set == PartSet::NONE)
        return "support is on without parts; expected parts=bricks";
    if (settings.needsCpu() &&
        (settings.voxelization.method != VoxelizationMethod::EXACT || settings.voxelization.device == Device::GPU))
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
    if (grid.resolution < 1 || grid.resolution > MAXIMUM_RESOLUTION)
        return rangeError("resolution", grid.resolution, "a whole number", 1u, MAXIMUM_RESOLUTION);
    if (std::string error = checkLattice(*this); !error.empty()) return error;
    if (voxelization.fboSize < MINIMUM_FBO_SIZE || voxelization.fboSize > MAXIMUM_FBO_SIZE)
        return rangeError("fbo", voxelization.fboSize, "a whole number of pixels", MINIMUM_FBO_SIZE, MAXIMUM_FBO_SIZE);
    const double edge = getEdgeLimit();
    if (!(edge >= MINIMUM_EDGE_LIMIT && edge <= MAXIMUM_EDGE_LIMIT))
        return rangeError("edge", edge, "a number of cells", MINIMUM_EDGE_LIMIT, MAXIMUM_EDGE_LIMIT);
    if (voxelization.method == VoxelizationMethod::EXACT && getTarget() != VoxelizationTarget::ADDRESSED)
        return "bad value 'projected' for target; expected addressed with method=exact";
    if (!(view.progress >= 0.0 && view.progress <= 1.0))
        return badValue("progress", toText(view.progress), EXPECTED_PROGRESS);
    if (voxelization.method == VoxelizationMethod::POINTS && voxelization.device == Device::CPU)
        return "bad value 'cpu' for device; expected auto or gpu with method=points";
    return checkParts(*this);
}

bool LegoSettings::isKey(const std::string& name)
{
    return isSettingsKey(name, KEYS);
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
    return parseSettings(
        text, [](std::string_view item) { return isNumber(item) ? "resolution" : ""; }, "a resolution (1 to 1024)",
        KEYS, SettingReader(), settings, error);
}

std::string LegoSettings::toString() const
{
    const LegoSettings defaults;
    std::ostringstream text;
    if (grid.cellPitch)
        text << "cell=" << toText(*grid.cellPitch);
    else
        text << grid.resolution;
    if (grid.origin) text << ",origin=" << vectorToText(*grid.origin);
    if (grid.size) text << ",size=" << vectorToText(*grid.size);
    if (grid.proportions != defaults.grid.proportions)
        text << ",proportions=" << nameOf(PROPORTIONS_NAMES, grid.proportions);
    if (grid.upAxis != defaults.grid.upAxis) text << ",up=" << nameOf(UP_NAMES, grid.upAxis);
    if (voxelization.method != defaults.voxelization.method)
        text << ",method=" << nameOf(METHOD_NAMES, voxelization.method);
    if (voxelization.target) text << ",target=" << nameOf(TARGET_NAMES, *voxelization.target);
    if (voxelization.fboSize != defaults.voxelization.fboSize) text << ",fbo=" << voxelization.fboSize;
    if (voxelization.edgeLimit) text << ",edge=" << toText(*voxelization.edgeLimit);
    if (voxelization.device != defaults.voxelization.device)
        text << ",device=" << nameOf(DEVICE_NAMES, voxelization.device);
    if (colors.palette) text << ",palette=" << *colors.palette;
    if (colors.count) text << ",colors=" << *colors.count;
    if (colors.dither) text << ",dither=on";
    if (parts.fill != defaults.parts.fill) text << ",fill=" << nameOf(FILL_NAMES, parts.fill);
    if (parts.shell != defaults.parts.shell) text << ",shell=" << parts.shell;
    if (parts.set != defaults.parts.set) text << ",parts=" << nameOf(PARTS_NAMES, parts.set);
    if (parts.seed != defaults.parts.seed) text << ",seed=" << parts.seed;
    if (parts.effort != defaults.parts.effort) text << ",effort=" << nameOf(EFFORT_NAMES, parts.effort);
    if (parts.support) text << ",support=on";
    if (view.look != defaults.view.look) text << ",look=" << nameOf(LOOK_NAMES, view.look);
    if (view.drawing != defaults.view.drawing) text << ",drawing=" << nameOf(DRAWING_NAMES, view.drawing);
    if (view.progress != defaults.view.progress) text << ",progress=" << toText(view.progress);
    if (view.show != defaults.view.show) text << ",show=" << nameOf(SHOW_NAMES, view.show);
    return text.str();
}

} // namespace osgLego
