#pragma once

#include <osgLego/LegoSettings.h>
#include <osgLego/Palette.h>

#include <string>

namespace osgLego
{

/** Read the palette that settings name, with all of its colours. May be called from any thread.
 * @return null if the settings have no palette, and, with one sentence in `error`, if it can't be read. */
osg::ref_ptr<const Palette> readPalette(const LegoSettings& settings, std::string& error);

/** One sentence if the palette that settings name can't be read; otherwise empty. LegoSettings::check() can't tell, as
 * it reads no files. May be called from any thread. */
std::string findPaletteError(const LegoSettings& settings);

} // namespace osgLego
