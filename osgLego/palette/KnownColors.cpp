#include <osgLego/palette/KnownColors.h>

#include <osgLego/palette/ColorTable.h>

#include <bit>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace osgLego
{

// Defined by a source that the build generates from the folder data/.
const std::map<std::string_view, std::string_view>& getEmbeddedColors();

namespace
{

bool isInDefaultPalette(const PaletteColor& color)
{
    constexpr int FEWEST_SIZES = 20;
    constexpr std::uint16_t SMALLEST = 1;
    return color.brickLink >= 0 && (color.bricks & color.plates & SMALLEST) != 0 &&
           std::popcount(color.bricks) + std::popcount(color.plates) >= FEWEST_SIZES;
}

osg::ref_ptr<const Palette> createDefaultPalette()
{
    std::vector<PaletteColor> colors;
    for (const PaletteColor& color : getKnownColors())
        if (isInDefaultPalette(color)) colors.push_back(color);
    std::string ignored; // the list has enough colours, and not too many
    return Palette::create(std::move(colors), ignored);
}

} // namespace

std::span<const PaletteColor> getKnownColors()
{
    std::string error;
    static const std::vector<PaletteColor> colors =
        readColorTable(getEmbeddedColors().at("ldraw-solid-colours.csv"), error);
    return colors;
}

osg::ref_ptr<const Palette> getDefaultPalette()
{
    static const osg::ref_ptr<const Palette> palette = createDefaultPalette();
    return palette;
}

} // namespace osgLego
