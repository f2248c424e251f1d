#pragma once

#include <osgLego/layout/PartMap.h>

namespace osgLego
{

/** Lay parts on cells that no other cell is above or below, in the middle of flat places, so that each part reaches a
 * cell above or below which there is one: a part that doesn't is a component of its own. The cells that are farthest
 * from such cells come first, since few parts reach them. Cells that no part connects stay uncovered. */
void layReachingParts(PartMap& map, const PartSizes& sizes);

} // namespace osgLego
