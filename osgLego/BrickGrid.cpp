#include <osgLego/BrickGrid.h>

#include <cmath>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

// An extent that exceeds a whole number of cells by less than this is a rounding error and adds no cell.
constexpr double EXTENT_TOLERANCE = 1e-6;

int indexOfLongest(const glm::dvec3& extent, int upIndex)
{
    const int first = 0;
    const int second = upIndex == 1 ? 2 : 1;
    const int horizontal = extent[second] > extent[first] ? second : first;
    return extent[upIndex] > extent[horizontal] ? upIndex : horizontal;
}

bool isFitToMeasure(const osg::BoundingBoxd& bounds)
{
    if (!bounds.valid()) return false;
    const double longest = (bounds._max - bounds._min).length();
    return std::isfinite(longest) && longest > 0.0;
}

} // namespace

BrickGrid BrickGrid::fit(const osg::BoundingBoxd& bounds, const LegoSettings& settings)
{
    BrickGrid grid;
    grid.upAxis = settings.upAxis;
    if (!isFitToMeasure(bounds)) return grid;

    const glm::dvec3 minimum(bounds.xMin(), bounds.yMin(), bounds.zMin());
    const glm::dvec3 extent = glm::dvec3(bounds.xMax(), bounds.yMax(), bounds.zMax()) - minimum;
    const int up = grid.getUpIndex();
    const int longest = indexOfLongest(extent, up);

    glm::dvec3 proportions(1.0);
    proportions[up] = settings.getCellHeight();
    const double pitch = extent[longest] / settings.resolution / proportions[longest];
    if (!(pitch > 0.0)) return grid;
    grid.cellSize = pitch * proportions;

    for (int axis = 0; axis < 3; ++axis)
    {
        const double cells = extent[axis] / grid.cellSize[axis];
        grid.dimensions[axis] = axis == longest ? static_cast<int>(settings.resolution)
                                                : std::max(1, static_cast<int>(std::ceil(cells - EXTENT_TOLERANCE)));
        const double spare = std::max(0.0, grid.dimensions[axis] * grid.cellSize[axis] - extent[axis]);
        const bool shared = axis != up && axis != longest;
        grid.origin[axis] = minimum[axis] - (shared ? 0.5 * spare : 0.0);
    }
    return grid;
}

std::size_t BrickGrid::getNumCells() const
{
    return static_cast<std::size_t>(dimensions.x) * static_cast<std::size_t>(dimensions.y) *
           static_cast<std::size_t>(dimensions.z);
}

glm::dvec3 BrickGrid::toCells(const osg::Vec3d& point) const
{
    return (glm::dvec3(point.x(), point.y(), point.z()) - origin) / cellSize;
}

osg::Matrixd BrickGrid::getCellsToModel() const
{
    return osg::Matrixd::scale(cellSize.x, cellSize.y, cellSize.z) *
           osg::Matrixd::translate(origin.x, origin.y, origin.z);
}

osg::BoundingBoxd BrickGrid::getBrickBounds() const
{
    if (getNumCells() == 0) return {};
    glm::dvec3 maximum = origin + cellSize * glm::dvec3(dimensions);
    maximum[getUpIndex()] += BrickDimensions::STUD_HEIGHT * getPitch();
    return {origin.x, origin.y, origin.z, maximum.x, maximum.y, maximum.z};
}

} // namespace osgLego
