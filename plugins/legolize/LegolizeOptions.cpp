#include "LegolizeOptions.h"

#include "LegolizeSettings.h"

#include <osgLego/text/SettingsText.h>

#include <sstream>
#include <string_view>

namespace
{

bool isSettingsOption(std::string_view option)
{
    const std::string_view first = option.substr(0, option.find(','));
    if (osgLego::isWholeNumber(first)) return true;
    const auto equals = first.find('=');
    if (equals == std::string_view::npos) return false;
    // Digits before a key are a resolution without a comma; LegolizeSettings::parse reports the missing comma.
    const auto begin = first.find_first_not_of("0123456789");
    return osgLego::isSettingsKey(first.substr(begin, equals - begin), LegolizeSettings::describe());
}

void append(std::string& list, const std::string& item, char separator)
{
    if (!list.empty()) list += separator;
    list += item;
}

} // namespace

LegolizeOptions LegolizeOptions::parse(const std::string& options)
{
    LegolizeOptions result;
    std::istringstream stream(options);
    for (std::string option; stream >> option;)
    {
        if (isSettingsOption(option))
            append(result.settings, option, ',');
        else
            append(result.rest, option, ' ');
    }
    return result;
}
