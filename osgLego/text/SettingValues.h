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
//     static constexpr SettingType TYPE;            for SettingDescription::type
//     SettingRange getRange() const;                for SettingDescription::range; only numbers have it
//     std::vector<std::string> getChoices() const;  for SettingDescription::choices; only names have it
//     std::string getForm() const;      for SettingDescription::form
//     std::string getValues() const;    for SettingDescription::values
//     std::string getExpected() const;  the same for error messages, "expected ..."
//     bool read(std::string_view text, Value& value) const;  whether the text has the form of a value
//     std::string write(const Value& value) const;
//     bool contains(const Value& value) const;  whether a value is valid; may also take the settings that it belongs to

/** The limits of a range, which double precision holds exactly, as text. */
template <typename Number>
std::string limitsOf(const SettingRange& range)
{
    return toText(static_cast<Number>(range.minimum)) + " to " + toText(static_cast<Number>(range.maximum));
}

/** Numbers in a range. */
template <typename Number>
class NumberRange
{
public:
    /** @param unit of the numbers, in plural; empty: none. */
    NumberRange(Number minimum, Number maximum, std::string unit = {}) :
        _range{static_cast<double>(minimum), static_cast<double>(maximum)}, _unit(std::move(unit))
    {
    }

    static constexpr SettingType TYPE = std::integral<Number> ? SettingType::WHOLE_NUMBER : SettingType::NUMBER;

    SettingRange getRange() const { return _range; }
    std::string getForm() const { return "<number>"; }
    std::string getValues() const { return limitsOf<Number>(_range) + (_unit.empty() ? "" : " " + _unit); }
    std::string getExpected() const
    {
        const std::string kind = std::integral<Number> ? "a whole number" : "a number";
        return kind + (_unit.empty() ? "" : " of " + _unit) + ", " + limitsOf<Number>(_range);
    }
    bool read(std::string_view text, Number& number) const { return readNumber(text, number); }
    std::string write(Number number) const { return toText(number); }
    bool contains(Number number) const { return _range.contains(static_cast<double>(number)); }

private:
    SettingRange _range;
    std::string _unit;
};

/** Three numbers. A kind of values derives from it, with their range. */
template <typename Vector>
class ThreeNumbers
{
public:
    static constexpr SettingType TYPE =
        std::integral<typename Vector::value_type> ? SettingType::THREE_WHOLE_NUMBERS : SettingType::THREE_NUMBERS;

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

    static constexpr SettingType TYPE = SettingType::CHOICE;

    std::vector<std::string> getChoices() const
    {
        std::vector<std::string> choices;
        for (const auto& [name, value] : _names)
            choices.push_back(name);
        return choices;
    }
    std::string getForm() const { return joinTexts(getChoices(), "|", "|"); }
    std::string getValues() const { return joinTexts(getChoices(), ", ", ", "); }
    std::string getExpected() const { return joinTexts(getChoices(), ", ", " or "); }
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
    std::vector<std::pair<std::string, Value>> _names;
};

/** A switch. */
class Switch : public Choice<bool>
{
public:
    Switch() : Choice<bool>{{"off", false}, {"on", true}} {}

    static constexpr SettingType TYPE = SettingType::SWITCH;
};

} // namespace osgLego
