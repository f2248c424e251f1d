#pragma once

#include <osgLego/BrickModel.h>

#include <optional>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The expected result of BrickRayCaster::findNearest, by testing every brick. */
std::optional<double> askEveryBrick(const BrickModel& model, const glm::dvec3& origin, const glm::dvec3& direction);

} // namespace osgLego
