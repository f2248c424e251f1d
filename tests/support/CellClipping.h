#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego::test
{

using Polygon = std::vector<glm::dvec3>;

/** The part of a convex polygon in a cell of the unit grid, faces included: the polygon is clipped by the cell's six
 * planes, one after the other. */
Polygon clipByCell(const Polygon& polygon, const glm::ivec3& cell);

/** The area of a convex polygon. */
double areaOf(const Polygon& polygon);

} // namespace osgLego::test
