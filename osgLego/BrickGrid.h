#pragma once

#include <osgLego/BrickDimensions.h>
#include <osgLego/Export.h>
#include <osgLego/LegoSettings.h>

#include <cstddef>

#include <glm/vec3.hpp>
#include <osg/BoundingBox>
#include <osg/Matrixd>
#include <osg/Vec3d>

namespace osgLego
{

/** The grid of cells that lies around a mesh: where each cell is, and how large.
 *
 * Cell (x, y, z) is the half-open box from `origin + (x, y, z) * cellSize` to `origin + (x+1, y+1, z+1) * cellSize`
 * in model units, the axes being those of the model. "Cell units" are model coordinates less `origin` over `cellSize`.
 *
 * The longest side of the bounds has exactly `resolution` cells; of sides equally long, a horizontal one counts. What
 * the other two sides leave over is shared by both ends of a horizontal side, so that a symmetric mesh gets symmetric
 * bricks, and lies on top of the vertical one, so that the lowest bricks stand where the mesh stands.
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
    glm::ivec3 dimensions{0}; //!< cells along each axis; zero in a grid around nothing
    UpAxis upAxis = UpAxis::Z;

    /** Lay a grid around `bounds` (model units, valid, finite, its longest side above 0).
     * @return a grid of no cells when the bounds do not meet that. */
    static BrickGrid fit(const osg::BoundingBoxd& bounds, const LegoSettings& settings);

    /** The index of the axis along which studs point: 1 or 2. */
    int getUpIndex() const { return upAxis == UpAxis::Y ? 1 : 2; }
    /** The width of a cell, in model units. */
    double getPitch() const { return cellSize.x; }
    /** The height of a stud, in cells along the axis that it points along. */
    double getStudHeight() const { return BrickDimensions::STUD_HEIGHT * getPitch() / cellSize[getUpIndex()]; }
    /** How many cells the grid has; up to 1024 * 1024 * 2560. */
    std::size_t getNumCells() const;

    /** From model units to cell units. */
    glm::dvec3 toCells(const osg::Vec3d& point) const;
    /** The transform from cell units to model units. */
    osg::Matrixd getCellsToModel() const;
    /** Where the bricks of a mesh that reaches every side of the grid lie, studs included, in model units. */
    osg::BoundingBoxd getBrickBounds() const;

    bool operator==(const BrickGrid&) const = default;
};

} // namespace osgLego
