#pragma once

#include <osgLego/text/SettingsKey.h>
#include <osgLego/text/SettingsText.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace osgLego
{

/** All keys of the text form of settings, in the order in which they are written. The first one may stand without its
 * name.
 *
 *     SettingsTable<Garden> table;
 *     table.add("area", &Garden::area, NumberRange(1.0, 1e6, "square metres"), "the area with the paths");
 *     table.add("fence", &Garden::hasFence, Switch(), "whether there is a fence");
 *
 * An error message is one sentence; it is empty if there is no error. */
template <typename Settings>
class SettingsTable
{
public:
    /** Add a key.
     * @param member the value, or an optional one.
     * @param values its kind; see SettingValues.h.
     * @param defaultValue in words; empty: that of settings constructed by default. */
    template <typename Member, typename Values>
    void add(const char* key, Member Settings::*member, Values values, const char* meaning,
             const char* defaultValue = "")
    {
        addMember(
            {key, {}, {}, {}, defaultValue, meaning},
            std::move(values), [member](auto& settings) -> auto& { return settings.*member; });
    }

    /** Add a key whose value is in a group: a member of the settings that is a struct. */
    template <typename Values, typename Access>
    void addMember(SettingDescription description, Values values, Access access)
    {
        using Key = MemberKey<Settings, Values, Access>;
        _keys.push_back(std::make_unique<Key>(std::move(description), std::move(values), access));
        _descriptions.push_back(_keys.back()->getDescription());
    }

    const SettingDescriptions& describe() const { return _descriptions; }

    /** Set one value, whether it is in range or not. @return an error message. */
    std::string read(std::string_view name, std::string_view text, Settings& settings) const
    {
        for (const auto& key : _keys)
            if (key->getDescription().key == name) return key->read(text, settings);
        return unknownKey(name, _descriptions);
    }

    /** @return an error message for the first value that is out of range. */
    std::string check(const Settings& settings) const
    {
        for (const auto& key : _keys)
            if (std::string error = key->check(settings); !error.empty()) return error;
        return {};
    }

    /** The shortest text from which the settings are read: a list of `key=value`.
     * @param hasFirst whether it begins with the value of the first key, without its name; otherwise it lacks this key.
     */
    std::string write(const Settings& settings, bool hasFirst = true) const
    {
        std::string text = hasFirst ? _keys.front()->write(settings) : std::string();
        for (const auto& key : _keys)
            if (key != _keys.front() && !key->isDefault(settings))
                text += (text.empty() ? "" : ",") + key->getDescription().key + "=" + key->write(settings);
        return text;
    }

private:
    std::vector<std::unique_ptr<const SettingsKey<Settings>>> _keys;
    SettingDescriptions _descriptions;
};

/** Adds keys whose values are in one group: in a member of the settings that is a struct. */
template <typename Settings, typename Group>
class SettingsGroup
{
public:
    SettingsGroup(SettingsTable<Settings>& table, const char* name, Group Settings::*group) :
        _table(table), _name(name), _group(group)
    {
    }

    /** Add a key, as SettingsTable::add() does. */
    template <typename Member, typename Values>
    void add(const char* key, Member Group::*member, Values values, const char* meaning, const char* defaultValue = "")
    {
        _table.addMember(
            {key, _name, {}, {}, defaultValue, meaning}, std::move(values),
            [ group = _group, member ](auto& settings) -> auto& { return settings.*group.*member; });
    }

private:
    SettingsTable<Settings>& _table;
    const char* _name;
    Group Settings::*_group;
};

} // namespace osgLego
