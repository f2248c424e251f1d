#include "NumberText.h"

namespace osgLego
{

std::string formatNumber(std::size_t number)
{
    std::string text = std::to_string(number);
    for (std::size_t place = text.size(); place > 3; place -= 3)
        text.insert(place - 3, ",");
    return text;
}

std::string countOf(std::size_t number, std::string_view noun)
{
    return formatNumber(number) + " " + std::string(noun) + (number == 1 ? "" : "s");
}

} // namespace osgLego
