#include <osgLego/AmbientOcclusionSettings.h>

#include <osgLego/data/SettingsText.h>

#include <array>
#include <cmath>

namespace osgLego
{

namespace
{

using Quality = AmbientOcclusionQuality;
using Output = AmbientOcclusionOutput;

constexpr std::array QUALITY_NAMES{SettingName<Quality>{"low", Quality::LOW},
                                   SettingName<Quality>{"medium", Quality::MEDIUM},
                                   SettingName<Quality>{"high", Quality::HIGH}};
constexpr std::array OUTPUT_NAMES{
    SettingName<Output>{"picture", Output::PICTURE}, SettingName<Output>{"occlusion", Output::OCCLUSION},
    SettingName<Output>{"bent-normals", Output::BENT_NORMALS}, SettingName<Output>{"irradiance", Output::IRRADIANCE},
    SettingName<Output>{"normals", Output::NORMALS}};
constexpr std::array SWITCH_NAMES{SettingName<bool>{"on", true}, SettingName<bool>{"off", false}};
constexpr std::string_view KEYS = "quality, radius, distant, show";
constexpr std::string_view RADIUS = "a number above 0, in units of the world";

std::string readSetting(std::string_view key, std::string_view value, AmbientOcclusionSettings& settings)
{
    if (key == "quality") return readName(key, value, QUALITY_NAMES, settings.quality);
    if (key == "radius") return readNumber(key, value, RADIUS, settings.radius.emplace());
    if (key == "distant") return readName(key, value, SWITCH_NAMES, settings.distant);
    if (key == "show") return readName(key, value, OUTPUT_NAMES, settings.output);
    return unknownKey(key, KEYS);
}

} // namespace

std::string AmbientOcclusionSettings::check() const
{
    if (radius && !(*radius > 0.0 && std::isfinite(*radius))) return badValue("radius", toText(*radius), RADIUS);
    return {};
}

bool AmbientOcclusionSettings::parse(const std::string& text, AmbientOcclusionSettings& settings, std::string& error)
{
    return parseSettings(
        text, [](std::string_view item) { return item.empty() ? "" : "quality"; }, "a quality (low, medium, high)",
        KEYS, readSetting, settings, error);
}

std::string AmbientOcclusionSettings::toString() const
{
    std::string text(nameOf(QUALITY_NAMES, quality));
    if (radius) text += ",radius=" + toText(*radius);
    if (!distant) text += ",distant=off";
    if (output != Output::PICTURE) text += ",show=" + std::string(nameOf(OUTPUT_NAMES, output));
    return text;
}

} // namespace osgLego
