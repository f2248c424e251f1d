#pragma once

#include <glm/vec3.hpp>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace osgLego
{

/** Call `function(voxel)` for every voxel of a grid, from several threads at once. */
template <typename Function>
void forEachVoxel(const glm::ivec3& size, const Function& function)
{
    // Isolated: while it waits here, the thread must not run tasks of the caller, which may need locks that it holds.
    oneapi::tbb::this_task_arena::isolate(
        [&]
        {
            oneapi::tbb::parallel_for(0, size.z,
                                      [&](int z)
                                      {
                                          for (int y = 0; y < size.y; ++y)
                                              for (int x = 0; x < size.x; ++x)
                                                  function(glm::ivec3(x, y, z));
                                      });
        });
}

} // namespace osgLego
