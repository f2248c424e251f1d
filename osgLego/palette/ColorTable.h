#pragma once

#include <osgLego/PaletteColor.h>

#include <string>
#include <string_view>
#include <vector>

namespace osgLego
{

/** Read a table of colours: the text of a .csv file with the columns of data/ldraw-solid-colours.csv, the first line
 * with their names. Empty lines and lines that begin with # are ignored.
 * @return no colours, with one sentence in `error` that names the bad line, if there is an error. */
std::vector<PaletteColor> readColorTable(std::string_view text, std::string& error);

} // namespace osgLego
