#include <osgLego/BrickGrid.h>

#include <cmath>
#include <sstream>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

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

/** A box of cells, with numbers too large for an int. */
struct CellRange
{
    glm::dvec3 first;
    glm::dvec3 count;
};

/** The cells of a lattice that bounds reach into. */
CellRange findCells(const BrickGrid& lattice, const osg::BoundingBoxd& bounds)
{
    const glm::dvec3 first = lattice.findFirstCell(bounds);
    // Positions are rounded to single precision, which may move them into the next cell.
    const glm::vec3 highest(lattice.toCells(bounds._max) - first);
    return {first, glm::floor(glm::dvec3(highest)) + 1.0};
}

BrickGrid createLattice(const LegoSettings& settings)
{
    BrickGrid lattice;
    lattice.upAxis = settings.grid.upAxis;
    lattice.cellSize = glm::dvec3(*settings.grid.cellPitch);
    lattice.cellSize[lattice.getUpIndex()] *= settings.getCellHeight();
    lattice.origin = settings.grid.origin.value_or(glm::dvec3(0.0));
    return lattice;
}

// In cells. Farther away, positions in double precision are too coarse to be assigned to cells.
constexpr double MAXIMUM_DISTANCE = 1e9;

/** A grid of cells of a given pitch; empty if there would be too many. */
BrickGrid createFromLattice(const osg::BoundingBoxd& bounds, const LegoSettings& settings)
{
    BrickGrid grid = createLattice(settings);
    if (settings.grid.size)
    {
        grid.dimensions = *settings.grid.size;
        return grid;
    }
    const CellRange cells = findCells(grid, bounds);
    if (!GridLimits::contain(cells.count, grid.getUpIndex())) return grid;
    grid.origin += cells.first * grid.cellSize;
    grid.dimensions = glm::ivec3(cells.count);
    return grid;
}

} // namespace

BrickGrid BrickGrid::fit(const osg::BoundingBoxd& bounds, const LegoSettings& settings)
{
    BrickGrid grid;
    grid.upAxis = settings.grid.upAxis;
    if (!isFitToMeasure(bounds)) return grid;
    if (settings.grid.cellPitch) return createFromLattice(bounds, settings);

    const glm::dvec3 minimum(bounds.xMin(), bounds.yMin(), bounds.zMin());
    const glm::dvec3 extent = glm::dvec3(bounds.xMax(), bounds.yMax(), bounds.zMax()) - minimum;
    const int up = grid.getUpIndex();
    const int longest = indexOfLongest(extent, up);

    glm::dvec3 proportions(1.0);
    proportions[up] = settings.getCellHeight();
    const double pitch = extent[longest] / settings.grid.resolution;
    if (!(pitch > 0.0)) return grid;
    grid.cellSize = pitch * proportions;

    for (int axis = 0; axis < 3; ++axis)
    {
        const double cells = extent[axis] / grid.cellSize[axis];
        grid.dimensions[axis] = std::max(1, static_cast<int>(std::ceil(cells - EXTENT_TOLERANCE)));
        const double spare = std::max(0.0, grid.dimensions[axis] * grid.cellSize[axis] - extent[axis]);
        const bool shared = axis != up && axis != longest;
        grid.origin[axis] = minimum[axis] - (shared ? 0.5 * spare : 0.0);
    }
    return grid;
}

std::string BrickGrid::findObstacle(const osg::BoundingBoxd& bounds, const LegoSettings& settings)
{
    if (!settings.grid.cellPitch || settings.grid.size || !isFitToMeasure(bounds)) return {};
    const BrickGrid lattice = createLattice(settings);
    const glm::dvec3 farthest =
        glm::max(glm::abs(lattice.toCells(bounds._min)), glm::abs(lattice.toCells(bounds._max)));
    if (!glm::all(glm::lessThanEqual(farthest, glm::dvec3(MAXIMUM_DISTANCE))))
        return "the model is too far from the grid's origin; expected at most 1e9 cells along each axis, by a larger "
               "cell "
               "or a nearer origin";
    const glm::dvec3 count = findCells(lattice, bounds).count;
    if (GridLimits::contain(count, lattice.getUpIndex())) return {};
    std::ostringstream text;
    text << "the model reaches into " << count.x << " x " << count.y << " x " << count.z << " cells; expected at most "
         << GridLimits::describe(lattice.getUpIndex())
         << ", by a larger cell, or by origin and size that select a part";
    return text.str();
}

glm::dvec3 BrickGrid::findFirstCell(const osg::BoundingBoxd& bounds) const
{
    return glm::floor(toCells(bounds._min) + EXTENT_TOLERANCE);
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
