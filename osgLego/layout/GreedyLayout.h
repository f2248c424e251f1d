#pragma once

#include <osgLego/layout/PartMap.h>

namespace osgLego
{

/** Cover all uncovered cells, with the largest parts first. The long sides of parts lie along x in every other layer
 * and along y in the rest, where both fit, so that parts overlap those below. */
void layGreedily(PartMap& map, const PartSizes& sizes);

} // namespace osgLego
