#pragma once

#include <osgLego/layout/PartMap.h>

#include <cstdint>
#include <vector>

namespace osgLego
{

/** Choose the colour of each part: that of its cells, and for parts of interior cells the commonest of their neighbours
 * in which their size exists.
 * @return the colours of anchors; other entries are meaningless. */
std::vector<std::uint16_t> choosePartColors(const PartMap& map, const PartSizes& sizes);

/** The parts of a layout of all cells, in these colours, sorted by z, y and x of their place. */
LaidParts collectParts(const PartMap& map, const PartSizes& sizes);

} // namespace osgLego
