#include "LegolizeName.h"

#include "LegolizeSettings.h"

#include <sstream>
#include <string_view>

#include <osgDB/FileNameUtils>

namespace
{

bool isNumber(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool isBracketed(std::string_view text)
{
    return text.size() >= 2 &&
           ((text.front() == '(' && text.back() == ')') || (text.front() == '[' && text.back() == ']'));
}

/** The last dot that is not inside brackets; npos when there is none. */
std::string::size_type findLastDot(std::string_view name)
{
    int depth = 0;
    for (auto place = name.size(); place-- > 0;)
    {
        const char letter = name[place];
        if (letter == ')' || letter == ']')
            ++depth;
        else if (letter == '(' || letter == '[')
            --depth;
        else if (letter == '/' && depth == 0)
            break;
        else if (letter == '.' && depth == 0)
            return place;
    }
    return std::string::npos;
}

bool isSettingsOption(std::string_view option)
{
    const std::string_view first = option.substr(0, option.find(','));
    if (isNumber(first)) return true;
    const auto equals = first.find('=');
    return equals != std::string_view::npos && LegolizeSettings::isKey(std::string(first.substr(0, equals)));
}

void append(std::string& list, const std::string& item, char separator)
{
    if (!list.empty()) list += separator;
    list += item;
}

} // namespace

bool LegolizeName::parse(const std::string& name, LegolizeName& result)
{
    if (!osgDB::equalCaseInsensitive(osgDB::getFileExtension(name), "legolize")) return false;
    result.fileName = osgDB::getNameLessExtension(name);
    result.settings.clear();

    const auto dot = findLastDot(result.fileName);
    if (dot != std::string::npos)
    {
        const std::string part = result.fileName.substr(dot + 1);
        const bool isInBrackets = isBracketed(part);
        if (isInBrackets || isNumber(part) || part.find('=') != std::string::npos)
        {
            result.settings = isInBrackets ? part.substr(1, part.size() - 2) : part;
            result.fileName.erase(dot);
        }
    }
    return !result.fileName.empty();
}

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
