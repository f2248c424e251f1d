#pragma once

#include <osgLego/PaletteColor.h>

#include <filesystem>
#include <string>
#include <vector>

namespace osgLego
{

/** Read the colours of a palette from a file, a .csv or a .ldr (see Palette::read()). May be called from any thread.
 * @return no colours, with one sentence in `error` that names the file and the bad line, if it can't be read. */
std::vector<PaletteColor> readPaletteFile(const std::filesystem::path& path, std::string& error);

} // namespace osgLego
