#pragma once

#include <array>
#include <charconv>
#include <functional>
#include <string>
#include <string_view>

namespace osgLego
{

/** A value and its name in the text form of settings. */
template <typename Value>
struct SettingName
{
    std::string_view text;
    Value value;
};

template <typename Value, std::size_t COUNT>
std::string_view nameOf(const std::array<SettingName<Value>, COUNT>& names, Value value)
{
    for (const auto& name : names)
        if (name.value == value) return name.text;
    return {};
}

template <typename Number>
std::string toText(Number number)
{
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return {buffer.data(), result.ptr};
}

/** A text without spaces, tabs and line ends at both ends. */
std::string_view trimmed(std::string_view text);

/** The error message for a bad value, in one sentence. @param expected the valid values, such as `y or z`. */
std::string badValue(std::string_view key, std::string_view value, std::string_view expected);

/** Read a number. @return an error message, empty if there is no error. */
template <typename Number>
std::string readNumber(std::string_view key, std::string_view text, std::string_view expected, Number& number)
{
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (code == std::errc() && end == text.data() + text.size()) return {};
    return badValue(key, text, expected);
}

/** Read three numbers separated by colons. @return an error message, empty if there is no error. */
template <typename Vector>
std::string readVector(std::string_view key, std::string_view text, std::string_view expected, Vector& vector)
{
    std::string_view rest = text;
    for (int component = 0; component < 3; ++component)
    {
        const auto end = rest.find(':');
        const bool isLast = component == 2;
        if ((end == std::string_view::npos) != isLast) return badValue(key, text, expected);
        if (!readNumber(key, rest.substr(0, end), expected, vector[component]).empty())
            return badValue(key, text, expected);
        if (!isLast) rest.remove_prefix(end + 1);
    }
    return {};
}

/** Read a name from a list. @return an error message, empty if there is no error. */
template <typename Value, std::size_t COUNT>
std::string readName(std::string_view key, std::string_view text, const std::array<SettingName<Value>, COUNT>& names,
                     Value& value)
{
    std::string expected;
    for (const auto& name : names)
    {
        if (name.text == text)
        {
            value = name.value;
            return {};
        }
        const std::string_view separator = expected.empty() ? "" : &name == &names.back() ? " or " : ", ";
        expected.append(separator).append(name.text);
    }
    return badValue(key, text, expected);
}

/** Read a list of `key=value`, separated by commas, up to the first error; a missing comma is an error.
 * @param bareKey returns the key of an item that is a value only; empty if the item is not valid without a key.
 * @param whatIsBare a description of such items, for the message.
 * @param read takes a key and its value; returns an error message, empty if there is no error.
 * @return the first error, in one sentence; empty if there is none. */
std::string readSettings(std::string_view text, const std::function<std::string_view(std::string_view item)>& bareKey,
                         std::string_view whatIsBare, std::string_view keys,
                         const std::function<std::string(std::string_view key, std::string_view value)>& read);

/** Read the text form of settings that have a check() function.
 * @param read takes a key, its value and the settings to change; see readSettings() for the other parameters.
 * @return false, with one sentence in `error` and `settings` unchanged, if there is an error. */
template <typename Settings, typename Read>
bool parseSettings(std::string_view text, const std::function<std::string_view(std::string_view item)>& bareKey,
                   std::string_view whatIsBare, std::string_view keys, Read read, Settings& settings,
                   std::string& error)
{
    Settings wanted = settings;
    std::string wrong =
        readSettings(text, bareKey, whatIsBare, keys,
                     [&](std::string_view key, std::string_view value) { return read(key, value, wanted); });
    if (wrong.empty()) wrong = wanted.check();
    if (!wrong.empty())
    {
        error = wrong;
        return false;
    }
    settings = wanted;
    return true;
}

/** Whether a name is one of the `keys`, which are separated by a comma and a space. */
bool isSettingsKey(std::string_view name, std::string_view keys);

/** The error message for a key that is not one of the `keys`. */
std::string unknownKey(std::string_view key, std::string_view keys);

} // namespace osgLego
