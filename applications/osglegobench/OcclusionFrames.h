#pragma once

#include "BenchScene.h"

#include <common/JsonValue.h>

#include <glm/vec2.hpp>

namespace osgLego
{

/** Compare frames of the same bricks without ambient occlusion, with that of the grid (BrickOcclusion::GRID),
 * and with that of an AmbientOcclusionScene. Draws the three in turns, after three rounds that are not timed.
 * @param numFrames of each kind, at least 1. @param size of the picture, in pixels.
 * @return a row of figures. Throws std::runtime_error. */
JsonValue compareOcclusionFrames(const BenchScene& scene, unsigned int numFrames, const glm::ivec2& size);

} // namespace osgLego
