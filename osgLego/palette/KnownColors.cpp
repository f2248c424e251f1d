#include <osgLego/palette/KnownColors.h>

#include <osgLego/palette/ColorTable.h>

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

namespace osgLego
{

// Defined by a source that the build generates from the folder data/.
const std::map<std::string_view, std::string_view>& getEmbeddedColors();

namespace
{

bool isDefaultColor(const PaletteColor& color)
{
    constexpr int FEWEST_SIZES = 20;
    constexpr std::uint16_t SMALLEST = 1;
    // Brown, Light Grey and Dark Grey, which other browns and greys replaced in 2004: they are sold used, if at all.
    constexpr std::array RETIRED{6, 7, 8};
    if (std::ranges::find(RETIRED, color.code) != RETIRED.end()) return false;
    return color.brickLink >= 0 && (color.bricks & color.plates & SMALLEST) != 0 &&
           std::popcount(color.bricks) + std::popcount(color.plates) >= FEWEST_SIZES;
}

} // namespace

std::span<const PaletteColor> getKnownColors()
{
    std::string error;
    static const std::vector<PaletteColor> colors =
        readColorTable(getEmbeddedColors().at("ldraw-solid-colours.csv"), error);
    return colors;
}

std::vector<PaletteColor> selectDefaultColors()
{
    std::vector<PaletteColor> colors;
    std::ranges::copy_if(getKnownColors(), std::back_inserter(colors), isDefaultColor);
    return colors;
}

} // namespace osgLego
