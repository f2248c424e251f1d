#pragma once

#include <optional>
#include <string>
#include <vector>

namespace osgLego
{

/** The kind of value that a key takes. */
enum class SettingType
{
    NUMBER,
    WHOLE_NUMBER,
    THREE_NUMBERS, //!< such as `0.5:0:2`
    THREE_WHOLE_NUMBERS,
    SWITCH, //!< off or on
    CHOICE, //!< one of SettingDescription::choices
    FILE    //!< the path of a file, or one of SettingDescription::choices
};

/** The least and the greatest valid number, both included. */
struct SettingRange
{
    double minimum = 0.0;
    double maximum = 0.0;

    bool contains(double number) const { return number >= minimum && number <= maximum; }
    bool operator==(const SettingRange&) const = default;
};

/** A key of the text form of settings, in words and as data: for help texts, documentation and user interfaces.
 *
 * Preconditions: none; a plain value.
 *
 * Usage:
 *
 *     for (const osgLego::SettingDescription& setting : osgLego::LegoSettings::describe())
 *         std::cout << setting.key << "  " << setting.values << ": " << setting.meaning << '\n';
 */
struct SettingDescription
{
    std::string key;          //!< such as `resolution`
    std::string group;        //!< the member that contains the value, such as `grid`; empty: the settings themselves
    std::string form;         //!< the value in a command line, such as `<number>` or `cube|brick|plate`
    std::string values;       //!< the valid values, such as `1 to 1024` or `cube, brick, plate`
    std::string defaultValue; //!< the default as a value, or in words
    std::string meaning;      //!< a phrase without a full stop
    SettingType type = SettingType::NUMBER;
    /** Of numbers, or of each of three, in the unit of `values`; unset for other types. If limits depend on other
     * settings, these are the widest. */
    std::optional<SettingRange> range = {};
    std::vector<std::string> choices = {}; //!< the names that the value may have; empty for numbers

    bool operator==(const SettingDescription&) const = default;
};

using SettingDescriptions = std::vector<SettingDescription>;

} // namespace osgLego
