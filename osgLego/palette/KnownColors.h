#pragma once

#include <osgLego/PaletteColor.h>

#include <span>
#include <vector>

namespace osgLego
{

/** All colours of data/ldraw-solid-colours.csv, which the library contains. May be called from any thread. */
std::span<const PaletteColor> getKnownColors();

/** The colours of the palette "ldraw": the known colours that have a number of BrickLink, in which the brick and the
 * plate of 1x1 were made, and at least 20 of the 22 sizes. May be called from any thread. */
std::vector<PaletteColor> selectDefaultColors();

} // namespace osgLego
