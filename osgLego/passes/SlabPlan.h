#pragma once

#include <osgLego/BrickGrid.h>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Layers (z) of a grid that are voxelized together. */
struct Slab
{
    int begin = 0;      //!< the first layer whose bricks it yields
    int end = 0;        //!< the one after the last
    int imageBegin = 0; //!< the first layer in the voxel image: the layer below, where there is one, and
    int imageEnd = 0;   //!< the layer above are there too, since they decide which sides are open
};

/** How a grid is cut into slabs, so that the voxel image of one fits into a texture of bounded size.
 *
 * A grid of up to MAXIMUM_TEXELS cells is one slab; beyond that, memory no longer grows with the grid.
 */
struct SlabPlan
{
    static constexpr int MAXIMUM_TEXELS = 1 << 24;
    static constexpr int MAXIMUM_WIDTH = 4096;

    std::vector<Slab> slabs;
    glm::ivec2 imageSize{0}; //!< of the voxel image, in texels; the width is a power of two

    static SlabPlan create(const BrickGrid& grid);
};

} // namespace osgLego
