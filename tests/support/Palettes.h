#pragma once

#include <osgLego/Palette.h>

#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** Create a palette of 1 to 255 colours. Throws std::invalid_argument for other numbers. */
osg::ref_ptr<const Palette> createPalette(std::vector<PaletteColor> colors);

} // namespace osgLego
