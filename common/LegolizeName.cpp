#include <common/LegolizeName.h>

#include <osgLego/text/SettingsText.h>

#include <string_view>
#include <vector>

#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

bool isBracketed(std::string_view text)
{
    return text.size() >= 2 &&
           ((text.front() == '(' && text.back() == ')') || (text.front() == '[' && text.back() == ']'));
}

/** The last dot outside brackets; npos if there is none. */
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

char closingOf(char bracket)
{
    return bracket == '(' ? ')' : ']';
}

/** Describe a character of a name and its position. */
std::string describe(const std::string& name, std::string::size_type place)
{
    return std::string("'") + name[place] + "' as character " + std::to_string(place + 1) + " of '" + name + "'";
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
        if (isInBrackets || isWholeNumber(part) || part.find('=') != std::string::npos)
        {
            result.settings = isInBrackets ? part.substr(1, part.size() - 2) : part;
            result.fileName.erase(dot);
        }
    }
    return !result.fileName.empty();
}

std::string LegolizeName::stripPseudoLoaders(const std::string& name)
{
    if (LegolizeName parsed; parse(name, parsed)) return stripPseudoLoaders(parsed.fileName);
    const std::string loader = osgDB::getLowerCaseFileExtension(name);
    if (loader != "rot" && loader != "scale" && loader != "trans") return name;
    const std::string arguments = osgDB::getNameLessExtension(name);
    const auto end = findLastDot(arguments);
    return end == std::string::npos ? name : stripPseudoLoaders(arguments.substr(0, end));
}

std::string LegolizeName::findLoneBracket(const std::string& name)
{
    std::vector<std::string::size_type> open;
    for (auto place = name.rfind('/') + 1; place < name.size(); ++place) // from 0 if there is no folder
    {
        const char letter = name[place];
        if (letter == '(' || letter == '[') open.push_back(place);
        if (letter != ')' && letter != ']') continue;
        const char opening = letter == ')' ? '(' : '[';
        if (open.empty())
            return describe(name, place) + " has no opening bracket; expected '" + opening + "' before it";
        if (name[open.back()] != opening)
            return describe(name, place) + " closes '" + name[open.back()] + "'; expected '" +
                   closingOf(name[open.back()]) + "'";
        open.pop_back();
    }
    if (open.empty()) return {};
    return describe(name, open.back()) + " is not closed; expected '" + closingOf(name[open.back()]) +
           "' before '.legolize'";
}

} // namespace osgLego
