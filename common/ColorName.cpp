#include <common/ColorName.h>

#include <algorithm>

namespace osgLego
{

std::string nameColor(const PaletteColor& color)
{
    std::string name = color.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

} // namespace osgLego
