#include "LegolizeSettings.h"

#include <osgLego/text/SettingValues.h>
#include <osgLego/text/SettingsTable.h>

#include <string_view>

namespace
{

using Occlusion = LegolizeSettings::Occlusion;

/** Names of pictures. They are not quoted, and end at the next comma. */
class PictureName
{
public:
    static constexpr osgLego::SettingType TYPE = osgLego::SettingType::FILE;

    std::string getForm() const { return "<file>"; }
    std::string getValues() const { return "the name of a high dynamic range picture, without commas"; }
    std::string getExpected() const { return getValues(); }
    bool read(std::string_view text, std::string& name) const
    {
        name = text;
        return true;
    }
    std::string write(const std::string& name) const { return name; }
    bool contains(const std::string& name) const { return !name.empty(); }
};

/** The keys beside those of LegoSettings. A setting is added here, and as a member in the header. */
const osgLego::SettingsTable<LegolizeSettings>& getTable()
{
    static const osgLego::SettingsTable<LegolizeSettings> table = []
    {
        osgLego::SettingsTable<LegolizeSettings> created;
        created.add("occlusion", &LegolizeSettings::occlusion,
                    osgLego::Choice<Occlusion>{{"off", Occlusion::OFF},
                                               {"grid", Occlusion::GRID},
                                               {"screen", Occlusion::SCREEN},
                                               {"both", Occlusion::BOTH},
                                               {"low", Occlusion::LOW},
                                               {"medium", Occlusion::MEDIUM},
                                               {"high", Occlusion::HIGH}},
                    "ambient occlusion in the full look: by the bricks of the grid, by everything in the picture (low, "
                    "medium or high quality), or both",
                    "grid; off with look=plain");
        created.add("distant", &LegolizeSettings::distant, osgLego::Switch(), "occlusion by distant bricks, too");
        created.add("probe", &LegolizeSettings::probe, PictureName(), "environment light", "a built-in sky");
        return created;
    }();
    return table;
}

} // namespace

osgLego::BrickOcclusion LegolizeSettings::getOcclusion() const
{
    switch (occlusion.value_or(Occlusion::GRID))
    {
    case Occlusion::OFF:
        return osgLego::BrickOcclusion::OFF;
    case Occlusion::GRID:
        return osgLego::BrickOcclusion::GRID;
    case Occlusion::BOTH:
        return osgLego::BrickOcclusion::BOTH;
    case Occlusion::SCREEN:
    case Occlusion::LOW:
    case Occlusion::MEDIUM:
    case Occlusion::HIGH:
        break;
    }
    return osgLego::BrickOcclusion::SCREEN;
}

std::optional<osgLego::AmbientOcclusionSettings> LegolizeSettings::getScene() const
{
    using Quality = osgLego::AmbientOcclusionQuality;
    osgLego::AmbientOcclusionSettings result;
    result.distant = distant;
    const bool isPlain = lego.view.look == osgLego::Look::PLAIN;
    switch (occlusion.value_or(isPlain ? Occlusion::OFF : Occlusion::GRID))
    {
    case Occlusion::OFF:
    case Occlusion::GRID:
        return std::nullopt;
    case Occlusion::LOW:
        result.quality = Quality::LOW;
        break;
    case Occlusion::SCREEN:
    case Occlusion::BOTH:
    case Occlusion::MEDIUM:
        result.quality = Quality::MEDIUM;
        break;
    case Occlusion::HIGH:
        result.quality = Quality::HIGH;
        break;
    }
    return result;
}

bool LegolizeSettings::parse(const std::string& text, LegolizeSettings& settings, std::string& error)
{
    LegolizeSettings wanted = settings;
    std::string bricks; // the text for LegoSettings, which reads some of its keys together
    const auto read = [&](std::string_view key, std::string_view value) -> std::string
    {
        if (osgLego::isSettingsKey(key, getTable().describe())) return getTable().read(key, value, wanted);
        if (!osgLego::isSettingsKey(key, describe())) return osgLego::unknownKey(key, describe());
        bricks.append(bricks.empty() ? "" : ",").append(key).append("=").append(value);
        return {};
    };
    std::string wrong = osgLego::readSettings(text, describe(), osgLego::isWholeNumber, read);
    if (wrong.empty()) wrong = getTable().check(wanted);
    if (wrong.empty() && !bricks.empty()) osgLego::LegoSettings::parse(bricks, wanted.lego, wrong);
    if (!wrong.empty())
    {
        error = wrong;
        return false;
    }
    settings = wanted;
    return true;
}

const osgLego::SettingDescriptions& LegolizeSettings::describe()
{
    static const osgLego::SettingDescriptions all = []
    {
        osgLego::SettingDescriptions keys = osgLego::LegoSettings::describe();
        const osgLego::SettingDescriptions& others = getTable().describe();
        keys.insert(keys.end(), others.begin(), others.end());
        return keys;
    }();
    return all;
}
