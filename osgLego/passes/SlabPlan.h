#pragma once

#include <osgLego/BrickGrid.h>
#include <vector>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Layers (z) of a grid that are voxelized together. */
struct Slab
{
    int begin = 0;      //!< the first layer
    int end = 0;        //!< the layer after the last
    int imageBegin = 0; //!< the first layer in the voxel image, which also holds the layers just below and above the
    int imageEnd = 0;   //!< slab, if the grid has them, since they determine its open sides; and the end of the image
};

/** The division of a grid into slabs, so that the voxel image of each fits into a texture of limited size.
 *
 * A grid whose images have at most MAXIMUM_TEXELS texels each, and MAXIMUM_BYTES bytes together, is one slab; for
 * larger grids, the size of the images stops growing.
 */
struct SlabPlan
{
    static constexpr int MAXIMUM_TEXELS = 1 << 24;
    static constexpr int MAXIMUM_BYTES = 1 << 27;
    static constexpr int MAXIMUM_WIDTH = 4096;

    std::vector<Slab> slabs;
    glm::ivec2 imageSize{0}; //!< of the voxel image, in texels; the width is a power of two

    /** @param cellBytes the size of a cell in the voxel image, and in other images of its size: 1 to 16, or more for a
     * grid that is one slab. */
    static SlabPlan create(const BrickGrid& grid, int cellBytes);
};

} // namespace osgLego
