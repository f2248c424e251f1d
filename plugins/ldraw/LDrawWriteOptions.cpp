#include "LDrawWriteOptions.h"

#include <string_view>

namespace osgLego
{

namespace
{

/** The value of key=value or key="value with spaces" in a string of options; empty if there is none. */
std::string findValue(std::string_view options, const std::string& key)
{
    const std::string begin = key + "=";
    std::size_t place = options.find(begin);
    while (place != std::string_view::npos && place > 0 && options[place - 1] != ' ')
        place = options.find(begin, place + 1);
    if (place == std::string_view::npos) return {};
    options.remove_prefix(place + begin.size());
    if (!options.starts_with('"')) return std::string(options.substr(0, options.find(' ')));
    options.remove_prefix(1);
    return std::string(options.substr(0, options.find('"')));
}

std::string findText(const osgDB::Options& options, const std::string& name, const std::string& key)
{
    std::string text = options.getPluginStringData(name);
    return text.empty() ? findValue(options.getOptionString(), key) : text;
}

} // namespace

LDrawWriteOptions LDrawWriteOptions::read(const osgDB::Options* options)
{
    if (!options) return {};
    return {{findText(*options, "TITLE", "title"), findText(*options, "AUTHOR", "author"),
             findText(*options, "LICENSE", "license")},
            findText(*options, "BASE", "base") == "plate"};
}

} // namespace osgLego
