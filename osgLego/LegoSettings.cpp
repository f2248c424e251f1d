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
    if (key == "resolution") return readNumber(key, value, "a whole number, 1 to 1024", settings.resolution);
    if (key == "cell") return readNumber(key, value, EXPECTED_CELL, settings.cellPitch.emplace());
    if (key == "origin") return readVector(key, value, EXPECTED_ORIGIN, settings.gridOrigin.emplace());
    if (key == "size") return readVector(key, value, EXPECTED_SIZE, settings.gridSize.emplace());
    if (key == "proportions") return readName(key, value, PROPORTIONS_NAMES, settings.proportions);
    if (key == "up") return readName(key, value, UP_NAMES, settings.upAxis);
    if (key == "method") return readName(key, value, METHOD_NAMES, settings.method);
    if (key == "target") return readName(key, value, TARGET_NAMES, settings.target.emplace());
    if (key == "fbo") return readNumber(key, value, "a whole number of pixels, 16 to 8192", settings.fboSize);
    if (key == "edge") return readNumber(key, value, "a number of cells, 0.0625 to 4", settings.edgeLimit.emplace());
    if (key == "device") return readName(key, value, DEVICE_NAMES, settings.device);
    if (key == "palette")
    {
        settings.palette.emplace(value);
        return {};
    }
    if (key == "colors") return readNumber(key, value, EXPECTED_COLORS, settings.numColors.emplace());
    if (key == "dither") return readName(key, value, SWITCH_NAMES, settings.dither);
    if (key == "fill") return readName(key, value, FILL_NAMES, settings.fill);
    if (key == "shell") return readNumber(key, value, EXPECTED_SHELL, settings.shell);
    if (key == "parts") return readName(key, value, PARTS_NAMES, settings.parts);
    if (key == "seed") return readNumber(key, value, "a whole number, 0 to 4294967295", settings.seed);
    if (key == "effort") return readName(key, value, EFFORT_NAMES, settings.effort);
    if (key == "support") return readName(key, value, SWITCH_NAMES, settings.support);
    if (key == "look") return readName(key, value, LOOK_NAMES, settings.look);
    if (key == "drawing") return readName(key, value, DRAWING_NAMES, settings.drawing);
    if (key == "progress") return readNumber(key, value, EXPECTED_PROGRESS, settings.progress);
    if (key == "show") return readName(key, value, SHOW_NAMES, settings.show);
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
            settings.cellPitch.reset();
            settings.gridOrigin.reset();
            settings.gridSize.reset();
        }
        if (isCells) _hasCells = true;
        if (key == "cell") settings.resolution = LegoSettings().resolution;
        if (key == "proportions") _hasProportions = true;
        std::string error = readSetting(key, value, settings);
        const bool isCube = settings.proportions == Proportions::CUBE;
        if (settings.parts != PartSet::NONE && isCube && !_hasProportions) settings.proportions = Proportions::BRICK;
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
    if (settings.gridOrigin && !settings.cellPitch) return "origin is given without cell; expected both";
    if (settings.gridSize && !settings.gridOrigin) return "size is given without origin; expected both, and cell";
    if (!settings.cellPitch) return {};
    if (settings.resolution != LegoSettings().resolution)
        return "a resolution can't be combined with cell; expected either";
    const double pitch = *settings.cellPitch;
    if (!(pitch >= LegoSettings::MINIMUM_CELL && pitch <= LegoSettings::MAXIMUM_CELL))
        return badValue("cell", toText(pitch), EXPECTED_CELL);
    if (settings.gridOrigin && !isInRange(*settings.gridOrigin))
        return badValue("origin", vectorToText(*settings.gridOrigin), EXPECTED_ORIGIN);
    if (settings.gridSize && !isInRange(*settings.gridSize, settings.upAxis))
        return badValue("size", vectorToText(*settings.gridSize), EXPECTED_SIZE);
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
    if (settings.palette && !isInTextForm(*settings.palette))
        return badValue("palette", *settings.palette, EXPECTED_PALETTE);
    if (settings.numColors && (*settings.numColors < 1 || *settings.numColors > LegoSettings::MAXIMUM_COLORS))
        return badValue("colors", toText(*settings.numColors), EXPECTED_COLORS);
    if (settings.shell < 1 || settings.shell > LegoSettings::MAXIMUM_SHELL)
        return badValue("shell", toText(settings.shell), EXPECTED_SHELL);
    if (settings.getPalette() == "none" && settings.numColors)
        return "colors is given without a palette; expected palette=ldraw or a file";
    if (settings.getPalette() == "none" && settings.dither)
        return "dither is on without a palette; expected palette=ldraw or a file";
    if (settings.parts != PartSet::NONE && settings.proportions == Proportions::CUBE)
        return "bad value 'cube' for proportions; expected brick or plate with parts";
    if (settings.support && settings.parts == PartSet::NONE)
        return "support is on without parts; expected parts=bricks";
    if (settings.needsCpu() && (settings.method != VoxelizationMethod::EXACT || settings.device == Device::GPU))
        return "parts, and fill other than surface, are made on the CPU; expected method=exact, and device=auto or cpu";
    return {};
}

} // namespace

VoxelizationTarget LegoSettings::getTarget() const
{
    if (target) return *target;
    return method == VoxelizationMethod::POINTS ? VoxelizationTarget::PROJECTED : VoxelizationTarget::ADDRESSED;
}

double LegoSettings::getEdgeLimit() const
{
    if (edgeLimit) return *edgeLimit;
    return method == VoxelizationMethod::POINTS ? 1.0 : 2.0;
}

std::string LegoSettings::getPalette() const
{
    if (palette) return *palette;
    return parts == PartSet::NONE ? "none" : "ldraw";
}

bool LegoSettings::needsCpu() const
{
    return parts != PartSet::NONE || fill != Fill::SURFACE;
}

double LegoSettings::getCellHeight() const
{
    switch (proportions)
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
    if (resolution < 1 || resolution > MAXIMUM_RESOLUTION)
        return rangeError("resolution", resolution, "a whole number", 1u, MAXIMUM_RESOLUTION);
    if (std::string error = checkLattice(*this); !error.empty()) return error;
    if (fboSize < MINIMUM_FBO_SIZE || fboSize > MAXIMUM_FBO_SIZE)
        return rangeError("fbo", fboSize, "a whole number of pixels", MINIMUM_FBO_SIZE, MAXIMUM_FBO_SIZE);
    const double edge = getEdgeLimit();
    if (!(edge >= MINIMUM_EDGE_LIMIT && edge <= MAXIMUM_EDGE_LIMIT))
        return rangeError("edge", edge, "a number of cells", MINIMUM_EDGE_LIMIT, MAXIMUM_EDGE_LIMIT);
    if (method == VoxelizationMethod::EXACT && getTarget() != VoxelizationTarget::ADDRESSED)
        return "bad value 'projected' for target; expected addressed with method=exact";
    if (!(progress >= 0.0 && progress <= 1.0)) return badValue("progress", toText(progress), EXPECTED_PROGRESS);
    if (method == VoxelizationMethod::POINTS && device == Device::CPU)
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
    alike.look = look;
    alike.drawing = drawing;
    alike.progress = progress;
    alike.show = show;
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
    if (cellPitch)
        text << "cell=" << toText(*cellPitch);
    else
        text << resolution;
    if (gridOrigin) text << ",origin=" << vectorToText(*gridOrigin);
    if (gridSize) text << ",size=" << vectorToText(*gridSize);
    if (proportions != defaults.proportions) text << ",proportions=" << nameOf(PROPORTIONS_NAMES, proportions);
    if (upAxis != defaults.upAxis) text << ",up=" << nameOf(UP_NAMES, upAxis);
    if (method != defaults.method) text << ",method=" << nameOf(METHOD_NAMES, method);
    if (target) text << ",target=" << nameOf(TARGET_NAMES, *target);
    if (fboSize != defaults.fboSize) text << ",fbo=" << fboSize;
    if (edgeLimit) text << ",edge=" << toText(*edgeLimit);
    if (device != defaults.device) text << ",device=" << nameOf(DEVICE_NAMES, device);
    if (palette) text << ",palette=" << *palette;
    if (numColors) text << ",colors=" << *numColors;
    if (dither) text << ",dither=on";
    if (fill != defaults.fill) text << ",fill=" << nameOf(FILL_NAMES, fill);
    if (shell != defaults.shell) text << ",shell=" << shell;
    if (parts != defaults.parts) text << ",parts=" << nameOf(PARTS_NAMES, parts);
    if (seed != defaults.seed) text << ",seed=" << seed;
    if (effort != defaults.effort) text << ",effort=" << nameOf(EFFORT_NAMES, effort);
    if (support) text << ",support=on";
    if (look != defaults.look) text << ",look=" << nameOf(LOOK_NAMES, look);
    if (drawing != defaults.drawing) text << ",drawing=" << nameOf(DRAWING_NAMES, drawing);
    if (progress != defaults.progress) text << ",progress=" << toText(progress);
    if (show != defaults.show) text << ",show=" << nameOf(SHOW_NAMES, show);
    return text.str();
}

} // namespace osgLego
