#include <osgLego/data/OcclusionPath.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

/** A direction of Fibonacci's lattice. @param z its last component. */
glm::dvec3 createDirection(int index, double z)
{
    const double angle = 2.0 * std::numbers::pi * std::numbers::phi * index;
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

} // namespace

OcclusionPath::OcclusionPath(const VoxelGrid& grid, const glm::dvec3& origin, const glm::dvec3& direction,
                             double reach) :
    _direction(direction)
{
    const glm::dvec3 lengths = glm::max(glm::abs(direction), 1e-12);
    const glm::dvec3 steps = grid.getExtent() / lengths;
    glm::dvec3 next =
        glm::mix(origin, grid.getExtent() - origin, glm::greaterThan(direction, glm::dvec3(0.0))) / lengths;
    glm::ivec3 voxel(0);
    while (true)
    {
        const int axis = next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2;
        const double distance = next[axis];
        if (distance >= reach) break;
        voxel[axis] += direction[axis] < 0.0 ? -1 : 1;
        next[axis] += steps[axis];
        _steps.push_back({voxel, distance});
        _offsets.push_back(static_cast<std::int32_t>(grid.getOffset(voxel)));
    }
    countSteps(grid);
}

/** Count the steps from each voxel along each axis until the ray leaves the grid along this axis. */
void OcclusionPath::countSteps(const VoxelGrid& grid)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        std::vector<std::uint16_t> moves; // the steps along the axis
        for (std::size_t step = 0; step < _steps.size(); ++step)
            if (_steps[step].voxel[axis] != (step == 0 ? 0 : _steps[step - 1].voxel[axis]))
                moves.push_back(static_cast<std::uint16_t>(step));
        const int last = grid.getSize()[axis] - 1 - VoxelGrid::BORDER;
        for (int voxel = 0; voxel < grid.getSize()[axis]; ++voxel)
        {
            const int ahead = _direction[axis] < 0.0f ? voxel - VoxelGrid::BORDER : last - voxel;
            const auto move = static_cast<std::size_t>(std::max(ahead, 0));
            const std::size_t num = ahead < 0 ? 0 : move < moves.size() ? moves[move] : _steps.size();
            _numsInside[static_cast<std::size_t>(axis)].push_back(static_cast<std::uint16_t>(num));
        }
    }
}

std::vector<glm::dvec3> createSphere(int numDirections)
{
    std::vector<glm::dvec3> directions;
    directions.reserve(static_cast<std::size_t>(numDirections));
    for (int index = 0; index < numDirections; ++index)
        directions.push_back(createDirection(index, 1.0 - (2.0 * index + 1.0) / numDirections));
    return directions;
}

std::vector<glm::dvec3> createHemisphere(int numDirections)
{
    std::vector<glm::dvec3> directions;
    directions.reserve(static_cast<std::size_t>(numDirections));
    for (int index = 0; index < numDirections; ++index)
        directions.push_back(createDirection(index, std::sqrt(1.0 - (index + 0.5) / numDirections)));
    return directions;
}

} // namespace osgLego
