#pragma once

#include <array>
#include <charconv>
#include <functional>
#include <string>
#include <string_view>

namespace osgLego
{

/** A value and what it is called in the text form of settings. */
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

/** The message about a value, in one sentence. @param expected the values that are, such as `y or z`. */
std::string badValue(std::string_view key, std::string_view value, std::string_view expected);

/** Read a number. @return what is wrong with it; empty when nothing is. */
template <typename Number>
std::string readNumber(std::string_view key, std::string_view text, std::string_view expected, Number& number)
{
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (code == std::errc() && end == text.data() + text.size()) return {};
    return badValue(key, text, expected);
}

/** Read a name of a list. @return what is wrong with it; empty when nothing is. */
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

/** Go through a list of `key=value`, separated by commas, up to the first mistake; a missing comma is one.
 * @param bareKey answers the key that an item without one is for; empty when it is for none.
 * @param whatIsBare what such an item may be, for the message.
 * @param read takes a key and its value and answers what is wrong with them; empty when nothing is.
 * @return what is wrong, in one sentence; empty when nothing is. */
std::string readSettings(std::string_view text, const std::function<std::string_view(std::string_view item)>& bareKey,
                         std::string_view whatIsBare, std::string_view keys,
                         const std::function<std::string(std::string_view key, std::string_view value)>& read);

/** Read the text form of settings that have a check() of their own: all of it or nothing.
 * @param read takes a key, its value and the settings to put it into; for the rest see readSettings().
 * @return false, with one sentence in `error` and `settings` unchanged, on a mistake. */
template <typename Settings, typename Read>
bool parseSettings(std::string_view text, const std::function<std::string_view(std::string_view item)>& bareKey,
                   std::string_view whatIsBare, std::string_view keys, const Read& read, Settings& settings,
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

/** Whether a name is one of `keys`, which are separated by a comma and a space. */
bool isSettingsKey(std::string_view name, std::string_view keys);

/** The message about a key that is not one of `keys`. */
std::string unknownKey(std::string_view key, std::string_view keys);

} // namespace osgLego
