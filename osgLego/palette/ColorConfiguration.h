#pragma once

#include <osgLego/PaletteColor.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace osgLego
{

/** Read the solid colours of a configuration of LDraw: the text of LDConfig.ldr. Transparent colours and those with a
 * finish or a material, and the codes 16 and 24, are ignored.
 * @param known gives the sizes and the numbers of BrickLink by code, and the colour of black plastic. Colours with
 * other codes have all sizes and no number.
 * @return no colours, with one sentence in `error` that names the bad line, if there is an error. */
std::vector<PaletteColor> readColorConfiguration(std::string_view text, std::span<const PaletteColor> known,
                                                 std::string& error);

} // namespace osgLego
