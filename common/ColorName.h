#pragma once

#include <osgLego/PaletteColor.h>

#include <string>

namespace osgLego
{

/** The name of a colour for readers, such as "Dark Turquoise"; #RRGGBB for a colour of no palette. */
std::string nameColor(const PaletteColor& color);

} // namespace osgLego
