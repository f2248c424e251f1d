#include <osgLego/LegoSettings.h>

#include <osgLego/data/SettingsText.h>

#include <array>
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
constexpr std::string_view KEYS = "resolution, proportions, up, method, target, fbo, edge, device, look, drawing";

bool isNumber(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/** Read one value. @return what is wrong with it; empty when nothing is. */
std::string readSetting(std::string_view key, std::string_view value, LegoSettings& settings)
{
    if (key == "resolution") return readNumber(key, value, "a whole number, 1 to 1024", settings.resolution);
    if (key == "proportions") return readName(key, value, PROPORTIONS_NAMES, settings.proportions);
    if (key == "up") return readName(key, value, UP_NAMES, settings.upAxis);
    if (key == "method") return readName(key, value, METHOD_NAMES, settings.method);
    if (key == "target") return readName(key, value, TARGET_NAMES, settings.target.emplace());
    if (key == "fbo") return readNumber(key, value, "a whole number of pixels, 16 to 8192", settings.fboSize);
    if (key == "edge") return readNumber(key, value, "a number of cells, 0.0625 to 4", settings.edgeLimit.emplace());
    if (key == "device") return readName(key, value, DEVICE_NAMES, settings.device);
    if (key == "look") return readName(key, value, LOOK_NAMES, settings.look);
    if (key == "drawing") return readName(key, value, DRAWING_NAMES, settings.drawing);
    return unknownKey(key, KEYS);
}

template <typename Number>
std::string rangeError(const char* key, Number value, const char* unit, Number minimum, Number maximum)
{
    return badValue(key, toText(value), std::string(unit) + ", " + toText(minimum) + " to " + toText(maximum));
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
    if (fboSize < MINIMUM_FBO_SIZE || fboSize > MAXIMUM_FBO_SIZE)
        return rangeError("fbo", fboSize, "a whole number of pixels", MINIMUM_FBO_SIZE, MAXIMUM_FBO_SIZE);
    const double edge = getEdgeLimit();
    if (!(edge >= MINIMUM_EDGE_LIMIT && edge <= MAXIMUM_EDGE_LIMIT))
        return rangeError("edge", edge, "a number of cells", MINIMUM_EDGE_LIMIT, MAXIMUM_EDGE_LIMIT);
    if (method == VoxelizationMethod::EXACT && getTarget() != VoxelizationTarget::ADDRESSED)
        return "bad value 'projected' for target; allowed with method=exact: addressed";
    if (method == VoxelizationMethod::POINTS && device == Device::CPU)
        return "bad value 'cpu' for device; allowed with method=points: auto, gpu";
    return {};
}

bool LegoSettings::isKey(const std::string& name)
{
    constexpr std::string_view SEPARATOR = ", ";
    std::string_view keys = KEYS;
    while (true)
    {
        const auto end = keys.find(SEPARATOR);
        if (keys.substr(0, end) == name) return true;
        if (end == std::string_view::npos) return false;
        keys.remove_prefix(end + SEPARATOR.size());
    }
}

bool LegoSettings::givesSameBricks(const LegoSettings& other) const
{
    LegoSettings alike = other;
    alike.look = look;
    alike.drawing = drawing;
    return alike == *this;
}

bool LegoSettings::parse(const std::string& text, LegoSettings& settings, std::string& error)
{
    return parseSettings(
        text, [](std::string_view item) { return isNumber(item) ? "resolution" : ""; }, "a resolution (1 to 1024)",
        KEYS, readSetting, settings, error);
}

std::string LegoSettings::toString() const
{
    const LegoSettings defaults;
    std::ostringstream text;
    text << resolution;
    if (proportions != defaults.proportions) text << ",proportions=" << nameOf(PROPORTIONS_NAMES, proportions);
    if (upAxis != defaults.upAxis) text << ",up=" << nameOf(UP_NAMES, upAxis);
    if (method != defaults.method) text << ",method=" << nameOf(METHOD_NAMES, method);
    if (target) text << ",target=" << nameOf(TARGET_NAMES, *target);
    if (fboSize != defaults.fboSize) text << ",fbo=" << fboSize;
    if (edgeLimit) text << ",edge=" << toText(*edgeLimit);
    if (device != defaults.device) text << ",device=" << nameOf(DEVICE_NAMES, device);
    if (look != defaults.look) text << ",look=" << nameOf(LOOK_NAMES, look);
    if (drawing != defaults.drawing) text << ",drawing=" << nameOf(DRAWING_NAMES, drawing);
    return text.str();
}

} // namespace osgLego
