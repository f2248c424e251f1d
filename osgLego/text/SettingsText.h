#pragma once

#include <osgLego/SettingDescription.h>

#include <array>
#include <charconv>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace osgLego
{

template <typename Number>
std::string toText(Number number)
{
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return {buffer.data(), result.ptr};
}

/** Read a number. @return whether the text is one; otherwise `number` is undefined. */
template <typename Number>
bool readNumber(std::string_view text, Number& number)
{
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    return code == std::errc() && end == text.data() + text.size();
}

/** Texts in a row. @param last the separator of the last two. */
std::string joinTexts(const std::vector<std::string>& texts, std::string_view separator, std::string_view last);

/** Whether a text consists of digits alone. */
bool isWholeNumber(std::string_view text);

/** A text without spaces, tabs and line ends at both ends. */
std::string_view trimmed(std::string_view text);

/** A text of a file for a message, which unlike a setting the user may not have typed: in quotation marks, shortened,
 * and without characters that a terminal may not show.
 */
std::string quoteForMessage(std::string_view text);

/** The error message for a bad value, in one sentence. @param expected the valid values, such as `y or z`. */
std::string badValue(std::string_view key, std::string_view value, std::string_view expected);

/** Whether a name is one of the keys. */
bool isSettingsKey(std::string_view name, const SettingDescriptions& keys);

/** The error message for a name that is not one of the keys. */
std::string unknownKey(std::string_view name, const SettingDescriptions& keys);

/** Read a list of `key=value`, separated by commas, up to the first error; a missing comma is an error.
 * @param keys at least one; the first one may be left out.
 * @param isFirst whether an item that has no key is a value of the first one.
 * @param read takes a key and its value; returns an error message, empty if there is no error.
 * @return the first error, in one sentence; empty if there is none. */
std::string readSettings(std::string_view text, const SettingDescriptions& keys,
                         const std::function<bool(std::string_view item)>& isFirst,
                         const std::function<std::string(std::string_view key, std::string_view value)>& read);

/** Read the text form of settings that have a check() function.
 * @param read takes a key, its value and the settings to change; see readSettings() for the other parameters.
 * @return false, with one sentence in `error` and `settings` unchanged, if there is an error. */
template <typename Settings, typename Read>
bool parseSettings(std::string_view text, const SettingDescriptions& keys,
                   const std::function<bool(std::string_view item)>& isFirst, Read read, Settings& settings,
                   std::string& error)
{
    Settings wanted = settings;
    std::string wrong = readSettings(
        text, keys, isFirst, [&](std::string_view key, std::string_view value) { return read(key, value, wanted); });
    if (wrong.empty()) wrong = wanted.check();
    if (!wrong.empty())
    {
        error = wrong;
        return false;
    }
    settings = wanted;
    return true;
}

} // namespace osgLego
