#include "PublishedOverlap.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

/** Whether an axis crossed with an edge keeps the triangle, which is given from the box's centre, apart from the box.
 */
bool isApart(const std::array<glm::vec3, 3>& triangle, const glm::vec3& halfSize, const glm::vec3& axis)
{
    const float a = glm::dot(axis, triangle[0]);
    const float b = glm::dot(axis, triangle[1]);
    const float c = glm::dot(axis, triangle[2]);
    const float radius = glm::dot(halfSize, glm::abs(axis));
    return std::min({a, b, c}) > radius || std::max({a, b, c}) < -radius;
}

} // namespace

bool overlapsBox(const std::array<glm::vec3, 3>& triangle, const glm::vec3& center, const glm::vec3& halfSize)
{
    const std::array<glm::vec3, 3> moved{triangle[0] - center, triangle[1] - center, triangle[2] - center};
    const std::array<glm::vec3, 3> edges{moved[1] - moved[0], moved[2] - moved[1], moved[0] - moved[2]};
    for (const glm::vec3& edge : edges)
    {
        if (isApart(moved, halfSize, {0.0f, -edge.z, edge.y})) return false;
        if (isApart(moved, halfSize, {edge.z, 0.0f, -edge.x})) return false;
        if (isApart(moved, halfSize, {-edge.y, edge.x, 0.0f})) return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto [minimum, maximum] = std::minmax({moved[0][axis], moved[1][axis], moved[2][axis]});
        if (minimum > halfSize[axis] || maximum < -halfSize[axis]) return false;
    }
    return !isApart({moved[0], moved[0], moved[0]}, halfSize, glm::cross(edges[0], edges[1]));
}

} // namespace osgLego
