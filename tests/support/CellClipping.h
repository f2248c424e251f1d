#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego::test
{

using Polygon = std::vector<glm::dvec3>;

/** The part of a convex polygon inside a cell of the unit grid, including its faces, by clipping with the cell's six
 * planes in turn. */
Polygon clipByCell(const Polygon& polygon, const glm::ivec3& cell);

/** The area of a convex polygon. */
double areaOf(const Polygon& polygon);

} // namespace osgLego::test
