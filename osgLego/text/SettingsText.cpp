#include <osgLego/text/SettingsText.h>

#include <algorithm>
#include <cstddef>
#include <set>

namespace osgLego
{

namespace
{

std::string quoted(std::string_view text)
{
    return "'" + std::string(text) + "'";
}

std::string listKeys(const SettingDescriptions& keys)
{
    std::string list = "the keys are";
    for (const SettingDescription& setting : keys)
        list += (&setting == &keys.front() ? " " : ", ") + setting.key;
    return list;
}

/** Where a `key=value` begins behind another item, as in `64up=y`; 0 when there is none. */
std::size_t findSecondItem(std::string_view item, const SettingDescriptions& keys)
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

std::string joinTexts(const std::vector<std::string>& texts, std::string_view separator, std::string_view last)
{
    std::string joined = texts.empty() ? std::string() : texts.front();
    for (std::size_t index = 1; index < texts.size(); ++index)
        joined.append(index + 1 == texts.size() ? last : separator).append(texts[index]);
    return joined;
}

bool isWholeNumber(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view SPACE = " \t\r\n";
    const auto begin = text.find_first_not_of(SPACE);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(SPACE) - begin + 1);
}

std::string quoteForMessage(std::string_view text)
{
    constexpr std::size_t LONGEST = 40;
    std::string result(text.substr(0, LONGEST));
    std::replace_if(
        result.begin(), result.end(), [](unsigned char character) { return character < ' ' || character > '~'; }, '?');
    return "'" + result + (text.size() > LONGEST ? "...'" : "'");
}

std::string badValue(std::string_view key, std::string_view value, std::string_view expected)
{
    return "bad value '" + std::string(value) + "' for " + std::string(key) + "; expected " + std::string(expected);
}

bool isSettingsKey(std::string_view name, const SettingDescriptions& keys)
{
    return std::any_of(keys.begin(), keys.end(),
                       [name](const SettingDescription& setting) { return setting.key == name; });
}

std::string unknownKey(std::string_view name, const SettingDescriptions& keys)
{
    return "unknown key " + quoted(name) + "; " + listKeys(keys);
}

std::string readSettings(std::string_view text, const SettingDescriptions& keys,
                         const std::function<bool(std::string_view item)>& isFirst,
                         const std::function<std::string(std::string_view key, std::string_view value)>& read)
{
    const SettingDescription& first = keys.front();
    std::set<std::string, std::less<>> seen;
    const auto readItem = [&](std::string_view item) -> std::string
    {
        const auto equals = item.find('=');
        const bool hasKey = equals != std::string_view::npos;
        if (!hasKey && !isFirst(item))
            return quoted(item) + " is neither a " + first.key + " (" + first.values + ") nor key=value; " +
                   listKeys(keys);
        const std::string_view key = hasKey ? trimmed(item.substr(0, equals)) : std::string_view(first.key);
        if (seen.contains(key)) return quoted(key) + " is given twice";
        std::string error = read(key, hasKey ? trimmed(item.substr(equals + 1)) : item);
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
