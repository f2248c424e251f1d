#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Whether a triangle and a box have a point in common, as in Akenine-Moller, Fast 3D Triangle-Box Overlap Testing,
 * 2001: thirteen axes, one after another, in floats, the box closed on all sides. Independent of TriangleOverlap. */
bool overlapsBox(const std::array<glm::vec3, 3>& triangle, const glm::vec3& center, const glm::vec3& halfSize);

} // namespace osgLego
