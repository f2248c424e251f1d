#pragma once

#include <string>
#include <vector>

namespace osgLego
{

/** A key of the text form of settings, in words: for help texts, documentation and user interfaces.
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

    bool operator==(const SettingDescription&) const = default;
};

using SettingDescriptions = std::vector<SettingDescription>;

} // namespace osgLego
