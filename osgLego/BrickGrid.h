#pragma once

#include <osgLego/BrickDimensions.h>
#include <osgLego/Export.h>
#include <osgLego/LegoSettings.h>

#include <cstddef>
#include <string>

#include <glm/vec3.hpp>
#include <osg/BoundingBox>
#include <osg/Matrixd>
#include <osg/Vec3d>

namespace osgLego
{

/** The grid of cells around a mesh: the position and the size of its cells.
 *
 * Cell (x, y, z) is the half-open box from `origin + (x, y, z) * cellSize` to `origin + (x+1, y+1, z+1) * cellSize`
 * in model units, along the axes of the model. A point in "cell units" is `(point - origin) / cellSize`.
 *
 * Without a cell pitch in the settings, the grid is fitted to bounds. The longest side of the bounds is `resolution`
 * widths of a cell long, so that a model has the same real size in all proportions; if several sides are equally long,
 * a horizontal one counts as the longest. The other sides, and a vertical one, are rounded up to whole cells. A
 * horizontal side shares the excess between both ends, so that a symmetric mesh gets symmetric bricks; the vertical
 * side has it at the top, so that the lowest bricks stand where the mesh stands.
 *
 * With a cell pitch, the grid is a box of cells of a lattice, which extends from LegoSettings::Grid::origin in all
 * directions: `gridSize` cells from there on, or without a size the cells that the bounds reach into. Such a grid need
 * not contain the mesh; a surface exactly between two cells belongs to the upper one, even at the end of the grid.
 *
 * Usage:
 *
 *     const osgLego::BrickGrid grid = osgLego::BrickGrid::fit(bounds, settings);
 *     const glm::dvec3 cell = glm::floor(grid.toCells(point));
 *
 * A plain value without GL; every function may be called from any thread.
 */
struct OSGLEGO_EXPORT BrickGrid
{
    glm::dvec3 origin{0.0};   //!< the corner of cell (0, 0, 0), in model units
    glm::dvec3 cellSize{1.0}; //!< the edges of a cell, in model units
    glm::ivec3 dimensions{0}; //!< cells along each axis; zero in an empty grid
    UpAxis upAxis = UpAxis::Z;

    /** The grid of a mesh with `bounds`, in model units: expected valid, finite, and with a longest side above 0.
     * @return an empty grid for any other bounds, and if findObstacle() reports an obstacle. */
    static BrickGrid fit(const osg::BoundingBoxd& bounds, const LegoSettings& settings);

    /** The reason, in one sentence, why cells of the given pitch can't fill `bounds`; empty if they can. */
    static std::string findObstacle(const osg::BoundingBoxd& bounds, const LegoSettings& settings);

    /** The index of the axis along which studs point: 1 or 2. */
    int getUpIndex() const { return upAxis == UpAxis::Y ? 1 : 2; }
    /** The width of a cell, in model units. */
    double getPitch() const { return cellSize.x; }
    /** The height of a stud, in cells along the up axis. */
    double getStudHeight() const { return BrickDimensions::STUD_HEIGHT * getPitch() / cellSize[getUpIndex()]; }
    /** The number of cells; for the most, see GridLimits. */
    std::size_t getNumCells() const;

    /** Convert a point from model units to cell units. */
    glm::dvec3 toCells(const osg::Vec3d& point) const;
    /** The lowest cell that `bounds`, in model units, reach into, in a grid that extends in all directions. */
    glm::dvec3 findFirstCell(const osg::BoundingBoxd& bounds) const;
    /** The transform from cell units to model units. */
    osg::Matrixd getCellsToModel() const;
    /** The bounds of all bricks that the grid can hold, studs included, in model units; invalid for an empty grid. */
    osg::BoundingBoxd getBrickBounds() const;

    bool operator==(const BrickGrid&) const = default;
};

} // namespace osgLego
