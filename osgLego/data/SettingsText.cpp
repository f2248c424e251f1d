#include <osgLego/data/SettingsText.h>

#include <set>

namespace osgLego
{

namespace
{

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view SPACE = " \t\r\n";
    const auto begin = text.find_first_not_of(SPACE);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(SPACE) - begin + 1);
}

} // namespace

std::string badValue(std::string_view key, std::string_view value, std::string_view allowed)
{
    return "bad value '" + std::string(value) + "' for " + std::string(key) + "; allowed: " + std::string(allowed);
}

std::string unknownKey(std::string_view key, std::string_view keys)
{
    return "unknown key '" + std::string(key) + "'; the keys are " + std::string(keys);
}

std::string readSettings(std::string_view text, const std::function<std::string_view(std::string_view item)>& bareKey,
                         std::string_view whatIsBare, std::string_view keys,
                         const std::function<std::string(std::string_view key, std::string_view value)>& read)
{
    std::set<std::string, std::less<>> seen;
    while (true)
    {
        const auto comma = text.find(',');
        const std::string_view item = trimmed(text.substr(0, comma));
        const auto equals = item.find('=');
        const bool isBare = equals == std::string_view::npos;
        const std::string_view key = isBare ? bareKey(item) : trimmed(item.substr(0, equals));
        if (isBare && key.empty())
            return "'" + std::string(item) + "' is neither " + std::string(whatIsBare) +
                   " nor key=value; the keys are " + std::string(keys);
        if (!seen.emplace(key).second) return "'" + std::string(key) + "' is given twice";
        std::string error = read(key, isBare ? item : trimmed(item.substr(equals + 1)));
        if (!error.empty()) return error;
        if (comma == std::string_view::npos) return {};
        text.remove_prefix(comma + 1);
    }
}

} // namespace osgLego
