#pragma once

#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/passes/SlabPlan.h>

#include <bit>

namespace osgLego
{

/** Set the uniforms of shaders/passes/addressing.glsl, which map the cells of a slab to texels of a voxel image. */
inline void setAddressing(const ProgramUniforms& uniforms, const BrickGrid& grid, const Slab& slab,
                          const glm::ivec2& imageSize)
{
    uniforms.set("gridSize", grid.dimensions);
    uniforms.set("slab", glm::ivec2(slab.imageBegin, slab.imageEnd));
    uniforms.set("voxelImageSize", imageSize);
    uniforms.set("voxelImageShift", std::countr_zero(static_cast<unsigned int>(imageSize.x)));
}

} // namespace osgLego
