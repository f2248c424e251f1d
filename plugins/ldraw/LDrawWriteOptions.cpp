#include "LDrawWriteOptions.h"

#include <osgLego/text/SettingsText.h>

#include <algorithm>
#include <string_view>

namespace osgLego
{

namespace
{

/** The value of key=value or key="value with spaces" in a string of options; empty if there is none. */
std::string findValue(std::string_view options, std::string_view key)
{
    while (!options.empty())
    {
        const std::size_t end = std::min(options.find_first_of("= "), options.size());
        const std::string_view name = options.substr(0, end);
        const bool hasValue = end < options.size() && options[end] == '=';
        options.remove_prefix(std::min(end + 1, options.size()));
        if (!hasValue) continue;
        const bool isQuoted = options.starts_with('"');
        if (isQuoted) options.remove_prefix(1);
        const std::string_view value = options.substr(0, options.find(isQuoted ? '"' : ' '));
        if (name == key) return std::string(value);
        options.remove_prefix(std::min(value.size() + 1, options.size()));
    }
    return {};
}

std::string findText(const osgDB::Options& options, const std::string& name, std::string_view key)
{
    std::string text = options.getPluginStringData(name);
    return text.empty() ? findValue(options.getOptionString(), key) : text;
}

} // namespace

std::optional<LDrawWriteOptions> LDrawWriteOptions::read(const osgDB::Options* options, std::string& error)
{
    if (!options) return LDrawWriteOptions();
    const std::string base = findText(*options, "BASE", "base");
    if (!base.empty() && base != "plate")
    {
        error = badValue("base", base, "plate");
        return std::nullopt;
    }
    return LDrawWriteOptions{{findText(*options, "TITLE", "title"), findText(*options, "AUTHOR", "author"),
                              findText(*options, "LICENSE", "license")},
                             !base.empty()};
}

} // namespace osgLego
