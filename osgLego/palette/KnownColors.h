#pragma once

#include <osgLego/Palette.h>

#include <span>

namespace osgLego
{

/** All colours of data/ldraw-solid-colours.csv, which the library contains. May be called from any thread. */
std::span<const PaletteColor> getKnownColors();

/** The palette "ldraw": the known colours that have a number of BrickLink, in which the brick and the plate of 1x1 were
 * made, and at least 20 of the 22 sizes. Created once; may be called from any thread. */
osg::ref_ptr<const Palette> getDefaultPalette();

} // namespace osgLego
