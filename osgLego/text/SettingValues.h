#pragma once

#include <osgLego/text/SettingsText.h>

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace osgLego
{

// The kinds of values of settings. Each kind reads and writes a value, checks its range, and describes all values:
//
//     std::string getForm() const;      for SettingDescription::form
//     std::string getValues() const;    for SettingDescription::values
//     std::string getExpected() const;  the same for error messages, "expected ..."
//     bool read(std::string_view text, Value& value) const;  whether the text has the form of a value
//     std::string write(const Value& value) const;
//     bool contains(const Value& value) const;  whether a value is valid; may also take the settings that it belongs to

/** Numbers in a range. */
template <typename Number>
class NumberRange
{
public:
    /** @param unit of the numbers, in plural; empty: none. */
    NumberRange(Number minimum, Number maximum, std::string unit = {}) :
        _minimum(minimum), _maximum(maximum), _unit(std::move(unit))
    {
    }

    std::string getForm() const { return "<number>"; }
    std::string getValues() const { return getLimits() + (_unit.empty() ? "" : " " + _unit); }
    std::string getExpected() const
    {
        const std::string kind = std::integral<Number> ? "a whole number" : "a number";
        return kind + (_unit.empty() ? "" : " of " + _unit) + ", " + getLimits();
    }
    bool read(std::string_view text, Number& number) const { return readNumber(text, number); }
    std::string write(Number number) const { return toText(number); }
    bool contains(Number number) const { return number >= _minimum && number <= _maximum; }

private:
    std::string getLimits() const { return toText(_minimum) + " to " + toText(_maximum); }

    Number _minimum;
    Number _maximum;
    std::string _unit;
};

/** Three numbers. A kind of values derives from it, with their range. */
template <typename Vector>
class ThreeNumbers
{
public:
    bool read(std::string_view text, Vector& vector) const
    {
        for (int component = 0; component < 3; ++component)
        {
            const auto end = text.find(':');
            const bool isLast = component == 2;
            if ((end == std::string_view::npos) != isLast) return false;
            if (!readNumber(text.substr(0, end), vector[component])) return false;
            if (!isLast) text.remove_prefix(end + 1);
        }
        return true;
    }
    std::string write(const Vector& vector) const
    {
        return toText(vector.x) + ":" + toText(vector.y) + ":" + toText(vector.z);
    }
};

/** One of several values that have names. */
template <typename Value>
class Choice
{
public:
    Choice(std::initializer_list<std::pair<const char*, Value>> names) : _names(names.begin(), names.end()) {}

    std::string getForm() const { return join("|", "|"); }
    std::string getValues() const { return join(", ", ", "); }
    std::string getExpected() const { return join(", ", " or "); }
    bool read(std::string_view text, Value& value) const
    {
        for (const auto& [name, named] : _names)
            if (name == text)
            {
                value = named;
                return true;
            }
        return false;
    }
    std::string write(Value value) const
    {
        for (const auto& [name, named] : _names)
            if (named == value) return name;
        return {};
    }
    bool contains(Value value) const { return !write(value).empty(); }

private:
    std::string join(std::string_view separator, std::string_view last) const
    {
        std::string text = _names.front().first;
        for (std::size_t index = 1; index < _names.size(); ++index)
            text.append(index + 1 == _names.size() ? last : separator).append(_names[index].first);
        return text;
    }

    std::vector<std::pair<std::string, Value>> _names;
};

/** A switch. */
class Switch : public Choice<bool>
{
public:
    Switch() : Choice<bool>{{"off", false}, {"on", true}} {}
};

} // namespace osgLego
