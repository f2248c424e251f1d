#pragma once

#include <osgLego/SettingDescription.h>
#include <osgLego/text/SettingsText.h>

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace osgLego
{

/** One key of the text form of settings: its description, and how its value is read, written and checked. */
template <typename Settings>
class SettingsKey
{
public:
    virtual ~SettingsKey() = default;

    const SettingDescription& getDescription() const { return _description; }

    /** Set the value, whether it is in range or not. @return an error message, empty if there is no error. */
    virtual std::string read(std::string_view text, Settings& settings) const = 0;
    /** The value as text; empty if it is unset. */
    virtual std::string write(const Settings& settings) const = 0;
    /** @return an error message, empty if the value is valid or unset. */
    virtual std::string check(const Settings& settings) const = 0;

    bool isDefault(const Settings& settings) const { return write(settings) == write(Settings()); }

protected:
    explicit SettingsKey(SettingDescription description) : _description(std::move(description)) {}

    SettingDescription _description;
};

/** A key whose value is a member of the settings.
 *
 * `Values` is a kind of values (SettingValues.h). `Access` takes settings, constant or not, and returns a reference to
 * the member, which may be optional. */
template <typename Settings, typename Values, typename Access>
class MemberKey final : public SettingsKey<Settings>
{
public:
    MemberKey(SettingDescription description, Values values, Access access) :
        SettingsKey<Settings>(std::move(description)), _values(std::move(values)), _access(access)
    {
        SettingDescription& words = this->_description;
        words.form = _values.getForm();
        words.values = _values.getValues();
        words.type = Values::TYPE;
        if constexpr (requires { _values.getRange(); }) words.range = _values.getRange();
        if constexpr (requires { _values.getChoices(); }) words.choices = _values.getChoices();
        if (words.defaultValue.empty()) words.defaultValue = write(Settings());
    }

    std::string read(std::string_view text, Settings& settings) const override
    {
        bool isRead = false;
        if constexpr (IS_OPTIONAL)
            isRead = _values.read(text, _access(settings).emplace());
        else
            isRead = _values.read(text, _access(settings));
        return isRead ? std::string() : makeError(text);
    }

    std::string write(const Settings& settings) const override
    {
        const auto* value = find(settings);
        return value ? _values.write(*value) : std::string();
    }

    std::string check(const Settings& settings) const override
    {
        const auto* value = find(settings);
        return !value || isValid(*value, settings) ? std::string() : makeError(_values.write(*value));
    }

private:
    using Member = std::remove_cvref_t<decltype(std::declval<Access>()(std::declval<const Settings&>()))>;
    static constexpr bool IS_OPTIONAL = requires(Member member) { member.has_value(); };

    /** @return null if the value is unset. */
    auto find(const Settings& settings) const
    {
        const Member& member = _access(settings);
        if constexpr (IS_OPTIONAL)
            return member ? &*member : nullptr;
        else
            return &member;
    }

    bool isValid(const auto& value, const Settings& settings) const
    {
        if constexpr (requires { _values.contains(value, settings); })
            return _values.contains(value, settings);
        else
            return _values.contains(value);
    }

    std::string makeError(std::string_view text) const
    {
        return badValue(this->_description.key, text, _values.getExpected());
    }

    Values _values;
    Access _access;
};

} // namespace osgLego
