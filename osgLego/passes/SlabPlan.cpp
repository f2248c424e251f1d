#include <osgLego/passes/SlabPlan.h>

#include <osgLego/gl/GlRequirements.h>

#include <algorithm>
#include <bit>

namespace osgLego
{

static_assert(SlabPlan::MAXIMUM_WIDTH <= GlRequirements::TEXTURE_SIZE);

SlabPlan SlabPlan::create(const BrickGrid& grid, int cellBytes)
{
    SlabPlan plan;
    const int layerTexels = grid.dimensions.x * grid.dimensions.y;
    const int numLayers = grid.dimensions.z;
    if (layerTexels == 0 || numLayers == 0) return plan;

    // By GridLimits, a layer has at most 1024 x 2560 cells, so at least three layers fit.
    const int layersInImage = std::min(numLayers, std::min(MAXIMUM_TEXELS, MAXIMUM_BYTES / cellBytes) / layerTexels);
    const int step = layersInImage == numLayers ? numLayers : layersInImage - 2;
    for (int begin = 0; begin < numLayers; begin += step)
    {
        const int end = std::min(begin + step, numLayers);
        plan.slabs.push_back({begin, end, std::max(begin - 1, 0), std::min(end + 1, numLayers)});
    }

    const int texels = layerTexels * layersInImage;
    plan.imageSize.x = std::min(static_cast<int>(std::bit_ceil(static_cast<unsigned int>(texels))), MAXIMUM_WIDTH);
    plan.imageSize.y = (texels + plan.imageSize.x - 1) / plan.imageSize.x;
    return plan;
}

} // namespace osgLego
