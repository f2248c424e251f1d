#include <osgLego/voxelization/VoxelReader.h>

#include <osgLego/data/PassConstants.h>
#include <osgLego/data/WeightedColor.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace osgLego
{

namespace
{

/** The sum of weighted colours, and the sum of weights, that a texel of the exact method stands for, as in
 * shaders/passes/voxel_color.glsl. */
glm::vec4 sumOf(const glm::vec4& voxel)
{
    const float weights = std::isinf(voxel.a) ? static_cast<float>(PassConstants::LARGEST_SUM) : voxel.a;
    return {static_cast<float>(PassConstants::COLOR_CENTER) * weights + glm::vec3(voxel), weights};
}

} // namespace

void readBackBricks(VoxelFormat format, const glm::ivec2& imageSize, const Slab& slab, Legolization& work)
{
    const glm::ivec3& dimensions = work.source->triangles->getGrid().dimensions;
    std::vector<glm::vec4> texels(static_cast<std::size_t>(imageSize.x) * static_cast<std::size_t>(imageSize.y));
    glReadPixels(0, 0, imageSize.x, imageSize.y, GL_RGBA, GL_FLOAT, texels.data());

    std::size_t texel = static_cast<std::size_t>(slab.begin - slab.imageBegin) *
                        static_cast<std::size_t>(dimensions.x) * static_cast<std::size_t>(dimensions.y);
    for (int z = slab.begin; z < slab.end; ++z)
        for (int y = 0; y < dimensions.y; ++y)
            for (int x = 0; x < dimensions.x; ++x)
            {
                const glm::vec4& voxel = texels[texel++];
                if (!(voxel.a > 0.0f)) continue;
                Brick brick = makeBrick({x, y, z}, format == VoxelFormat::COLOR ? voxel : sumOf(voxel));
                brick.color = work.source->lookup.getColor(brick.color, brick.cell);
                work.readBack.push_back(brick);
            }
}

} // namespace osgLego
