#pragma once

#include <osgLego/Palette.h>

#include <filesystem>
#include <string>

namespace osgLego
{

/** Read a palette from a file, a .csv or a .ldr (see Palette::read()). The file is read each time; files with the
 * same colours may share a palette. May be called from any thread.
 * @return null, with one sentence in `error` that names the file and the bad line, if it can't be read. */
osg::ref_ptr<const Palette> readPaletteFile(const std::filesystem::path& path, std::string& error);

} // namespace osgLego
