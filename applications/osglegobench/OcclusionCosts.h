#pragma once

#include "BenchScene.h"

#include <common/JsonValue.h>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Time the first frame of bricks without ambient occlusion, with that of the grid, and with that of an
 * AmbientOcclusionScene, each in separate processes without a cache of compiled shaders: it compiles programs, makes
 * the bricks and their occlusion, and draws. See measureInSeparateProcess() for the requirements of the calling
 * process.
 * @param size of the picture, in pixels.
 * @param numRuns at least 1, of which the medians are taken.
 * @return a row of milliseconds, and of the seconds that the grid and the scene add. Throws std::runtime_error. */
JsonValue compareFirstFrames(const BenchScene& scene, const glm::ivec2& size, unsigned int numRuns);

/** Time the search for the cells around bricks (BrickNeighbors), by one thread on the CPU and on the GPU.
 * @param numRuns as above.
 * @return a row with the milliseconds, and their ratio to those of the same device's legolization without it; and the
 * milliseconds of the wall clock that distant occlusion takes. Throws std::runtime_error. */
JsonValue timeNeighbors(const BenchScene& scene, unsigned int numRuns);

} // namespace osgLego
