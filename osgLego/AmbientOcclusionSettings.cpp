#include <osgLego/AmbientOcclusionSettings.h>

#include <osgLego/text/SettingValues.h>
#include <osgLego/text/SettingsTable.h>

#include <limits>

namespace osgLego
{

namespace
{

/** Numbers above 0. */
class Radius
{
public:
    static constexpr SettingType TYPE = SettingType::NUMBER;

    SettingRange getRange() const
    {
        return {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()};
    }
    std::string getForm() const { return "<number>"; }
    std::string getValues() const { return "a number above 0, in units of the world"; }
    std::string getExpected() const { return getValues(); }
    bool read(std::string_view text, double& radius) const { return readNumber(text, radius); }
    std::string write(double radius) const { return toText(radius); }
    bool contains(double radius) const { return getRange().contains(radius); }
};

/** All keys. A setting is added here, and as a member in the header. */
const SettingsTable<AmbientOcclusionSettings>& getOcclusionTable()
{
    using Settings = AmbientOcclusionSettings;
    using Quality = AmbientOcclusionQuality;
    using Output = AmbientOcclusionOutput;
    static const SettingsTable<Settings> table = []
    {
        SettingsTable<Settings> created;
        created.add("quality", &Settings::quality,
                    Choice<Quality>{{"low", Quality::LOW}, {"medium", Quality::MEDIUM}, {"high", Quality::HIGH}},
                    "the amount of work per pixel");
        created.add("radius", &Settings::radius, Radius(), "the greatest distance of occluders",
                    "2.5 widths of a brick");
        created.add("distant", &Settings::distant, Switch(),
                    "whether bricks farther away than the radius occlude; no effect with radius");
        created.add("show", &Settings::output,
                    Choice<Output>{{"picture", Output::PICTURE},
                                   {"occlusion", Output::OCCLUSION},
                                   {"bent-normals", Output::BENT_NORMALS},
                                   {"irradiance", Output::IRRADIANCE},
                                   {"normals", Output::NORMALS}},
                    "the scene, or an intermediate result");
        return created;
    }();
    return table;
}

} // namespace

std::string AmbientOcclusionSettings::check() const
{
    return getOcclusionTable().check(*this);
}

const SettingDescriptions& AmbientOcclusionSettings::describe()
{
    return getOcclusionTable().describe();
}

bool AmbientOcclusionSettings::parse(const std::string& text, AmbientOcclusionSettings& settings, std::string& error)
{
    const auto read = [](std::string_view key, std::string_view value, AmbientOcclusionSettings& changed)
    { return getOcclusionTable().read(key, value, changed); };
    return parseSettings(
        text, describe(), [](std::string_view item) { return !item.empty(); }, read, settings, error);
}

std::string AmbientOcclusionSettings::toString() const
{
    return getOcclusionTable().write(*this);
}

} // namespace osgLego
