#include <osgLego/data/SettingsText.h>

#include <set>

namespace osgLego
{

namespace
{

std::string quoted(std::string_view text)
{
    return "'" + std::string(text) + "'";
}

/** Where a `key=value` begins behind another item, as in `64up=y`; 0 when there is none. */
std::size_t findSecondItem(std::string_view item, std::string_view keys)
{
    for (std::size_t place = 1; place < item.size(); ++place)
    {
        const auto equals = item.find('=', place);
        if (equals == std::string_view::npos) return 0;
        if (isSettingsKey(trimmed(item.substr(place, equals - place)), keys)) return place;
    }
    return 0;
}

std::string missingComma(std::string_view item, std::size_t second)
{
    const std::string_view before = trimmed(item.substr(0, second));
    const std::string_view after = trimmed(item.substr(second));
    return "a comma is missing before " + quoted(after) + " in " + quoted(item) + "; expected '" + std::string(before) +
           "," + std::string(after) + "'";
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view SPACE = " \t\r\n";
    const auto begin = text.find_first_not_of(SPACE);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(SPACE) - begin + 1);
}

std::string badValue(std::string_view key, std::string_view value, std::string_view expected)
{
    return "bad value '" + std::string(value) + "' for " + std::string(key) + "; expected " + std::string(expected);
}

bool isSettingsKey(std::string_view name, std::string_view keys)
{
    constexpr std::string_view SEPARATOR = ", ";
    while (true)
    {
        const auto end = keys.find(SEPARATOR);
        if (keys.substr(0, end) == name) return true;
        if (end == std::string_view::npos) return false;
        keys.remove_prefix(end + SEPARATOR.size());
    }
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
    const auto readItem = [&](std::string_view item) -> std::string
    {
        const auto equals = item.find('=');
        const bool isBare = equals == std::string_view::npos;
        const std::string_view key = isBare ? bareKey(item) : trimmed(item.substr(0, equals));
        if (isBare && key.empty())
            return quoted(item) + " is neither " + std::string(whatIsBare) + " nor key=value; the keys are " +
                   std::string(keys);
        if (seen.contains(key)) return quoted(key) + " is given twice";
        std::string error = read(key, isBare ? item : trimmed(item.substr(equals + 1)));
        if (error.empty()) seen.emplace(key);
        return error;
    };

    while (true)
    {
        const auto comma = text.find(',');
        const std::string_view item = trimmed(text.substr(0, comma));
        std::string error = readItem(item);
        if (!error.empty())
        {
            const auto second = findSecondItem(item, keys);
            const bool lacksComma = second != 0 && readItem(trimmed(item.substr(0, second))).empty();
            return lacksComma ? missingComma(item, second) : error;
        }
        if (comma == std::string_view::npos) return {};
        text.remove_prefix(comma + 1);
    }
}

} // namespace osgLego
