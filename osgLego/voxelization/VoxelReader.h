#pragma once

#include <osgLego/passes/PassWorkspace.h>
#include <osgLego/passes/SlabPlan.h>
#include <osgLego/passes/VoxelFormat.h>

namespace osgLego
{

/** Read the bricks of a slab from the image that was just drawn, with the palette's colours if the source has a
 * palette, and append them to those read back. Needs the image bound for drawing, and its context current.
 * @param imageSize in texels. */
void readBackBricks(VoxelFormat format, const glm::ivec2& imageSize, const Slab& slab, Legolization& work);

} // namespace osgLego
