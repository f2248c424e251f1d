#include <osgLego/Palette.h>

#include <osgLego/LegoSettings.h>
#include <osgLego/palette/Dither.h>
#include <osgLego/palette/KnownColors.h>
#include <osgLego/palette/NearestTable.h>
#include <osgLego/palette/PaletteFile.h>

#include <cmath>
#include <utility>

namespace osgLego
{

namespace
{

/** Four fifths of the distance between neighbours, if as many colours were spread evenly over the cube of colours. At
 * about this width, the mean of some cells is closest to the colour of the surface. */
int ditherAmplitudeFor(std::size_t numColors)
{
    return static_cast<int>(std::lround(0.8 * 256.0 / std::cbrt(static_cast<double>(numColors))));
}

} // namespace

Palette::Palette(std::vector<PaletteColor> colors) :
    _colors(std::move(colors)), _table(makeNearestTable(_colors)), _ditherAmplitude(ditherAmplitudeFor(_colors.size()))
{
}

osg::ref_ptr<const Palette> Palette::create(std::vector<PaletteColor> colors, std::string& error)
{
    if (!colors.empty() && colors.size() <= MAXIMUM_COLORS) return new Palette(std::move(colors));
    error = "the palette has " + std::to_string(colors.size()) + " colours; expected 1 to " +
            std::to_string(MAXIMUM_COLORS);
    return nullptr;
}

osg::ref_ptr<const Palette> Palette::read(const std::string& nameOrFile, std::string& error)
{
    return nameOrFile == "ldraw" ? getDefaultPalette() : readPaletteFile(nameOrFile, error);
}

osg::ref_ptr<const Palette> Palette::read(const LegoSettings& settings, std::string& error)
{
    const std::string name = settings.getPalette();
    return name == "none" ? nullptr : read(name, error);
}

std::span<const PaletteColor> Palette::getKnownColors()
{
    return osgLego::getKnownColors();
}

std::size_t Palette::findNearest(const std::array<std::uint8_t, 3>& color) const
{
    return _table[tableEntryOf(color)];
}

std::size_t Palette::findDithered(const std::array<std::uint8_t, 3>& color,
                                  const std::array<std::uint16_t, 3>& cell) const
{
    const std::array<std::uint8_t, 3>& nearest = _colors[findNearest(color)].color;
    return findNearest(Dither::dithered(color, nearest, cell, _ditherAmplitude));
}

} // namespace osgLego
