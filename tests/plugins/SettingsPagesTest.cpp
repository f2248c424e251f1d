#include <legolize/LegolizeSettings.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** A cell of a table without its markup, and without a link to another page at its end. */
std::string toPlainText(const std::string& cell)
{
    std::string text = std::regex_replace(cell, std::regex(R"(: \[[^\]]*\]\([^)]*\)\s*$)"), "");
    return std::regex_replace(text, std::regex(R"(`|^\s+|\s+$)"), "");
}

/** The settings in the tables of a page of docs/ whose first column is `key`. A heading such as
 * "Grid: `LegoSettings::grid`" names the group of the table below it. */
SettingDescriptions readPage(const std::string& page)
{
    std::ifstream file(OSGLEGO_SOURCE_FOLDER "/docs/" + page);
    EXPECT_TRUE(file) << page;
    const std::regex heading(R"(#+ .*)");
    const std::regex groupHeading(R"(#+ .*`LegoSettings::(\w+)`)");
    const std::regex row(R"(\|([^|]*)\|([^|]*)\|([^|]*)\|([^|]*)\|)");
    SettingDescriptions settings;
    std::string group;
    bool isInTable = false;
    std::smatch match;
    for (std::string line; std::getline(file, line);)
    {
        if (std::regex_match(line, heading)) group = std::regex_match(line, match, groupHeading) ? match.str(1) : "";
        const bool isRow = std::regex_match(line, match, row);
        const bool isHead = isRow && toPlainText(match[1]) == "key";
        isInTable = isRow && (isInTable || isHead);
        if (!isInTable || isHead || line.starts_with("|-")) continue;
        settings.push_back(
            {toPlainText(match[1]), group, "", toPlainText(match[2]), toPlainText(match[3]), toPlainText(match[4])});
    }
    return settings;
}

std::string toRow(const SettingDescription& setting)
{
    return setting.group + " | " + setting.key + " | " + setting.values + " | " + setting.defaultValue + " | " +
           setting.meaning;
}

std::string findRow(const SettingDescriptions& settings, const std::string& key)
{
    for (const SettingDescription& setting : settings)
        if (setting.key == key) return toRow(setting);
    return "no row for " + key;
}

std::vector<std::string> listKeys(const SettingDescriptions& settings)
{
    std::vector<std::string> keys;
    for (const SettingDescription& setting : settings)
        keys.push_back(setting.key);
    return keys;
}

void expectSame(const SettingDescriptions& onPage, const SettingDescriptions& settings)
{
    ASSERT_FALSE(settings.empty());
    for (const SettingDescription& setting : settings)
        EXPECT_EQ(findRow(onPage, setting.key), toRow(setting));
    EXPECT_EQ(listKeys(onPage), listKeys(settings));
}

/** The least and the greatest number in a text; unset if there is none. */
std::optional<SettingRange> findRange(const std::string& text)
{
    const std::regex number(R"(-?[0-9.]+(e[-+][0-9]+)?)");
    std::optional<SettingRange> range;
    for (std::sregex_iterator found(text.begin(), text.end(), number); found != std::sregex_iterator(); ++found)
    {
        const double value = std::stod(found->str());
        if (!range) range = {value, value};
        range->minimum = std::min(range->minimum, value);
        range->maximum = std::max(range->maximum, value);
    }
    return range;
}

/** The names in a column of values, such as "none, ldraw or a file". */
std::vector<std::string> findChoices(const std::string& text)
{
    const std::regex separator(", | or a file");
    return {std::sregex_token_iterator(text.begin(), text.end(), separator, -1), std::sregex_token_iterator()};
}

TEST(SettingsPages, StateTheRangesAndChoicesOfSettings)
{
    SettingDescriptions onPages = readPage("settings.md");
    for (const SettingDescription& setting : readPage("osgviewer.md"))
        onPages.push_back(setting);
    const SettingDescriptions& all = LegolizeSettings::describe();
    ASSERT_EQ(listKeys(onPages), listKeys(all));
    for (std::size_t index = 0; index < all.size(); ++index)
    {
        const SettingDescription& setting = all[index];
        const std::string& values = onPages[index].values;
        EXPECT_EQ(setting.range, findRange(values)) << setting.key;
        if (setting.choices.empty())
        {
            EXPECT_TRUE(setting.range || setting.type == SettingType::FILE) << setting.key;
            continue;
        }
        EXPECT_EQ(setting.choices, findChoices(values)) << setting.key;
    }
}

TEST(SettingsPages, SettingsOfBricksAreDocumentedAsTheyAre)
{
    expectSame(readPage("settings.md"), LegoSettings::describe());
}

TEST(SettingsPages, SettingsOfThePseudoLoaderAreDocumentedAsTheyAre)
{
    const SettingDescriptions& all = LegolizeSettings::describe();
    const auto first = static_cast<std::ptrdiff_t>(LegoSettings::describe().size());
    expectSame(readPage("osgviewer.md"), {all.begin() + first, all.end()});
}

TEST(SettingsPages, SettingsOfAmbientOcclusionAreDocumentedAsTheyAre)
{
    expectSame(readPage("look.md"), AmbientOcclusionSettings::describe());
}

} // namespace

} // namespace osgLego
