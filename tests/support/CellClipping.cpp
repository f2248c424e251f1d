#include "CellClipping.h"

#include <glm/geometric.hpp>

namespace osgLego::test
{

Polygon clipByCell(const Polygon& whole, const glm::ivec3& cell)
{
    Polygon polygon = whole;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
        {
            const double bound = sign > 0.0 ? cell[axis] : cell[axis] + 1.0;
            Polygon result;
            for (std::size_t index = 0; index < polygon.size(); ++index)
            {
                const glm::dvec3& from = polygon[index];
                const glm::dvec3& to = polygon[(index + 1) % polygon.size()];
                const double here = sign * (from[axis] - bound);
                const double there = sign * (to[axis] - bound);
                if (here >= 0.0) result.push_back(from);
                if ((here >= 0.0) == (there >= 0.0)) continue;
                // Interpolation is exact along axes on which both ends agree; these may lie on another plane of the
                // cell.
                result.push_back(from + here / (here - there) * (to - from));
                result.back()[axis] = bound;
            }
            polygon = result;
        }
    return polygon;
}

double areaOf(const Polygon& polygon)
{
    glm::dvec3 sum(0.0);
    for (std::size_t index = 2; index < polygon.size(); ++index)
        sum += glm::cross(polygon[index - 1] - polygon[0], polygon[index] - polygon[0]);
    return 0.5 * glm::length(sum);
}

} // namespace osgLego::test
