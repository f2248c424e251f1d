#include <osgLego/Palette.h>

#include <osgLego/palette/Dither.h>
#include <osgLego/palette/KnownColors.h>
#include <osgLego/palette/Oklab.h>
#include <osgLego/palette/PaletteFile.h>

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

constexpr int ENTRY_WIDTH = 256 / Palette::TABLE_SIDE;

std::size_t entryOf(const std::array<std::uint8_t, 3>& color)
{
    return static_cast<std::size_t>(color[0] / ENTRY_WIDTH +
                                    Palette::TABLE_SIDE *
                                        (color[1] / ENTRY_WIDTH + Palette::TABLE_SIDE * (color[2] / ENTRY_WIDTH)));
}

/** Four fifths of the distance between as many colours spread evenly over the cube of colours: of all widths, about the
 * one at which the mean of some cells is closest to the colour of the surface. */
int ditherAmplitudeFor(std::size_t numColors)
{
    return static_cast<int>(std::lround(0.8 * 256.0 / std::cbrt(static_cast<double>(numColors))));
}

std::uint8_t findNearestOf(const std::vector<glm::dvec3>& colors, const glm::dvec3& color)
{
    std::size_t nearest = 0;
    for (std::size_t index = 1; index < colors.size(); ++index)
        if (glm::distance(colors[index], color) < glm::distance(colors[nearest], color)) nearest = index;
    return static_cast<std::uint8_t>(nearest);
}

} // namespace

Palette::Palette(std::vector<PaletteColor> colors) :
    _colors(std::move(colors)), _ditherAmplitude(ditherAmplitudeFor(_colors.size()))
{
    std::vector<glm::dvec3> places;
    for (const PaletteColor& color : _colors)
        places.push_back(toOklab(color.color));
    constexpr auto SIDE = static_cast<std::size_t>(TABLE_SIDE);
    _table.resize(SIDE * SIDE * SIDE);
    const auto middleOf = [](std::size_t entry)
    { return static_cast<std::uint8_t>(entry * ENTRY_WIDTH + ENTRY_WIDTH / 2); };
    for (std::size_t entry = 0; entry < _table.size(); ++entry)
        _table[entry] = findNearestOf(
            places, toOklab({middleOf(entry % SIDE), middleOf(entry / SIDE % SIDE), middleOf(entry / SIDE / SIDE)}));
    // A colour of the palette is its own nearest, even if another one is nearer to the middle of its entry.
    for (std::size_t index = _colors.size(); index-- > 0;)
        _table[entryOf(_colors[index].color)] = static_cast<std::uint8_t>(index);
}

osg::ref_ptr<const Palette> Palette::read(const std::string& nameOrFile, std::string& error)
{
    return nameOrFile == "ldraw" ? getDefaultPalette() : readPaletteFile(nameOrFile, error);
}

std::size_t Palette::findNearest(const std::array<std::uint8_t, 3>& color) const
{
    return _table[entryOf(color)];
}

std::size_t Palette::findDithered(const std::array<std::uint8_t, 3>& color,
                                  const std::array<std::uint16_t, 3>& cell) const
{
    const std::array<std::uint8_t, 3>& nearest = _colors[findNearest(color)].color;
    return findNearest(Dither::dithered(color, nearest, cell, _ditherAmplitude));
}

} // namespace osgLego
