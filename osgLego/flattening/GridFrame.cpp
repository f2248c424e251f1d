#include <osgLego/flattening/GridFrame.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

// In cells. Compensates for rounding: a superfluous triangle costs little, but a missing one loses bricks.
constexpr double GENEROSITY = 1.0;
// In cells, far outside the grid: cells of the lattice may begin this much above the mesh, by
// BrickGrid::findFirstCell().
constexpr double TOLERANCE = 1e-3;
// A grid farther from the mesh than this, in cells, has no bricks.
constexpr double FAR_AWAY = 1e6;

} // namespace

GridFrame::GridFrame(const BrickGrid& grid, const osg::BoundingBoxd& bounds, bool isFitted) :
    _grid(grid), _isFitted(isFitted)
{
    if (isFitted) return;
    _corner = grid.findFirstCell(bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
        const double end = grid.toCells(bounds._max)[axis];
        if (end - _corner[axis] < MAXIMUM_EXTENT) continue;
        _isTooLong = true;
        _corner[axis] = -MARGIN;
    }
    _firstCell = glm::ivec3(glm::clamp(-_corner, -FAR_AWAY, FAR_AWAY));
}

glm::dvec3 GridFrame::toFrame(const glm::dvec3& position) const
{
    return _grid.toCells(osg::Vec3d(position.x, position.y, position.z)) - _corner;
}

glm::vec3 GridFrame::round(const glm::dvec3& position) const
{
    const glm::vec3 cells(position);
    if (!_isFitted) return glm::max(cells, glm::vec3(0.0f));
    glm::vec3 result;
    for (int axis = 0; axis < 3; ++axis)
    {
        const float end = std::nextafter(static_cast<float>(_grid.dimensions[axis]), 0.0f);
        result[axis] = std::clamp(cells[axis], 0.0f, end);
    }
    return result;
}

bool GridFrame::mayReachGrid(const Corners& corners) const
{
    if (_isFitted) return true;
    const auto& [a, b, c] = corners;
    const glm::dvec3 lowest = glm::min(a.position, glm::min(b.position, c.position));
    const glm::dvec3 highest = glm::max(a.position, glm::max(b.position, c.position));
    const glm::dvec3 end = glm::dvec3(_grid.dimensions) - _corner;
    return glm::all(glm::greaterThanEqual(highest, -_corner - GENEROSITY)) &&
           glm::all(glm::lessThanEqual(lowest, end + GENEROSITY));
}

bool GridFrame::mustCut(const Corners& corners) const
{
    if (!_isTooLong) return false;
    return std::any_of(corners.begin(), corners.end(),
                       [](const SceneVertex& corner)
                       {
                           return glm::any(glm::lessThan(corner.position, glm::dvec3(-TOLERANCE))) ||
                                  glm::any(glm::greaterThan(corner.position, glm::dvec3(MAXIMUM_EXTENT)));
                       });
}

} // namespace osgLego
