#pragma once

#include <osgLego/data/ParallelLoop.h>

#include <cstddef>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Call `function(voxel)` for every voxel of a grid, from several threads at once. */
template <typename Function>
void forEachVoxel(const glm::ivec3& size, const Function& function)
{
    forEachIndex(static_cast<std::size_t>(size.z),
                 [&](std::size_t index)
                 {
                     const auto z = static_cast<int>(index);
                     for (int y = 0; y < size.y; ++y)
                         for (int x = 0; x < size.x; ++x)
                             function(glm::ivec3(x, y, z));
                 });
}

} // namespace osgLego
