#pragma once

#include <osgLego/Palette.h>

#include <string>
#include <vector>

namespace osgLego
{

/** Palette::create(), or the same palette as before if it was among the last ones with these colours: tables take tens
 * of milliseconds to create. May be called from any thread. */
osg::ref_ptr<const Palette> sharePalette(std::vector<PaletteColor> colors, std::string& error);

} // namespace osgLego
