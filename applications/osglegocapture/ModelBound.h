#pragma once

#include <osgLego/LegoNode.h>

#include <cstddef>

namespace osgLego
{

/** The fewest parts that can cover the layers of a node's bricks, each by itself: the sum of LayerBound::parts. Takes
 * seconds to minutes. 0 unless the bricks are parts in a grid of bricks. Throws CaptureError if it is cancelled. */
std::size_t computeModelBound(const LegoNode& lego);

} // namespace osgLego
