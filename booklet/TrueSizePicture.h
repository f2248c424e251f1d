#pragma once

#include <osgLego/PartType.h>

#include <string>
#include <vector>

namespace osgLego
{

/** Draw parts from their long side, below each other, as large as they are, with their studs numbered.
 * @param types at least one.
 * @return an element of SVG whose unit is a millimetre of paper. */
std::string drawTrueSize(const std::vector<const PartType*>& types);

/** The height of that picture with its caption, in millimetres. */
double measureTrueSize(const std::vector<const PartType*>& types);

} // namespace osgLego
