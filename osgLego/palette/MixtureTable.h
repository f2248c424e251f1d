#pragma once

#include <osgLego/PaletteColor.h>

#include <span>
#include <vector>

namespace osgLego
{

/** For each entry of Palette::getTable(), two colours whose bricks imitate its middle: the pair whose mean in linear
 * light, as an eye sees it from a distance, has the least difference (CIEDE2000 between places of toMatchingLab()). The
 * difference between the two colours adds to that of their mean, so that bricks of very different colours are mixed
 * only where that helps. Entries of nearly neutral colours mix nearly neutral colours only.
 *
 * The pair is the best of the colours near the entry, not of all: the table takes nearly as long for 255 colours as for
 * 33.
 * @param colors 1 to PaletteLimits::MAXIMUM_COLORS.
 * @param nearest makeNearestTable() of these colours. Entries with a colour of the palette stay plain. */
std::vector<PaletteMixture> makeMixtureTable(std::span<const PaletteColor> colors,
                                             std::span<const std::uint8_t> nearest);

} // namespace osgLego
