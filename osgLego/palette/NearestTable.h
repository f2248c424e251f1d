#pragma once

#include <osgLego/PaletteColor.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** The entry of an sRGB colour in Palette::getTable(). */
inline std::size_t tableEntryOf(const std::array<std::uint8_t, 3>& color)
{
    constexpr int WIDTH = 256 / PaletteLimits::TABLE_SIDE;
    return static_cast<std::size_t>(color[0] / WIDTH +
                                    PaletteLimits::TABLE_SIDE *
                                        (color[1] / WIDTH + PaletteLimits::TABLE_SIDE * (color[2] / WIDTH)));
}

/** For each entry of Palette::getTable(), the index of the colour with the least CIEDE2000 from its middle between
 * places of toMatchingLab(), the first of equally near ones. A colour is its own nearest, even if another one is nearer
 * to the middle of its entry; of several colours in one entry, the first is.
 * @param colors 1 to PaletteLimits::MAXIMUM_COLORS. */
std::vector<std::uint8_t> makeNearestTable(std::span<const PaletteColor> colors);

} // namespace osgLego
