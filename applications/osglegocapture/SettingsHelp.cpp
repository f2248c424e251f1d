#include "SettingsHelp.h"

#include <cstddef>
#include <sstream>

namespace osgLego
{

namespace
{

constexpr std::size_t WIDTH = 100;
constexpr std::size_t INDENT = 15;

/** A key and its text, broken between words. */
std::string toParagraph(const std::string& key, const std::string& text)
{
    std::string line = "  " + key;
    line.resize(INDENT - 1, ' ');
    std::string paragraph;
    std::istringstream words(text);
    for (std::string word; words >> word;)
    {
        if (line.size() + 1 + word.size() > WIDTH)
        {
            paragraph += line + "\n";
            line.assign(INDENT - 1, ' ');
        }
        line += " " + word;
    }
    return paragraph + line + "\n";
}

} // namespace

std::string describeKeys(const SettingDescriptions& keys)
{
    std::string text;
    for (const SettingDescription& setting : keys)
        text += toParagraph(setting.key, setting.values + ": " + setting.meaning + " (" + setting.defaultValue + ")");
    return text;
}

} // namespace osgLego
