#include <common/ReadableName.h>

#include <common/LegolizeName.h>

#include <algorithm>
#include <cctype>

#include <osgDB/FileNameUtils>

namespace osgLego
{

namespace
{

bool isDigit(char letter)
{
    return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

bool isSeparator(char letter)
{
    return letter == '_' || letter == '-' || static_cast<unsigned char>(letter) <= ' ';
}

/** Whether the rest of a name begins with a version, such as "v2". */
bool isVersion(const std::string& name, std::size_t place)
{
    return name[place] == 'v' && place + 1 < name.size() && isDigit(name[place + 1]);
}

} // namespace

std::string toReadableName(const std::string& fileName)
{
    const std::string name = osgDB::getStrippedName(LegolizeName::stripPseudoLoaders(fileName));
    std::string readable;
    for (std::size_t place = 0; place < name.size(); ++place)
    {
        if (isSeparator(name[place])) continue;
        const bool isFirst = place == 0 || isSeparator(name[place - 1]);
        if (isFirst && !readable.empty()) readable += ' ';
        const bool isCapital = isFirst && !isVersion(name, place);
        readable += isCapital ? static_cast<char>(std::toupper(static_cast<unsigned char>(name[place]))) : name[place];
    }
    return readable;
}

} // namespace osgLego
