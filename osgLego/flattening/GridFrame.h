#pragma once

#include <osgLego/BrickGrid.h>
#include <osgLego/flattening/SceneTriangles.h>

#include <array>

#include <glm/vec3.hpp>
#include <osg/BoundingBox>

namespace osgLego
{

/** The coordinates in which GridTriangles stores positions: cell units, from a corner of a cell on. No position is
 * negative.
 *
 * In a grid that is fitted to a mesh, this corner is that of the grid, and all positions are inside the grid: a surface
 * on its far side belongs to the last cell.
 *
 * In a grid of cells of a given pitch, the corner depends only on the mesh and the lattice: positions are rounded to
 * single precision in the same way for every grid of a lattice, so that a cell does not depend on the grid around it.
 * If the mesh is longer than MAXIMUM_EXTENT, single precision can't hold positions in it; the corner then is MARGIN
 * cells below the grid, and triangles that reach farther than MAXIMUM_EXTENT must be cut.
 *
 * A plain value; may be used from any thread.
 */
class GridFrame
{
public:
    using Corners = std::array<SceneVertex, 3>;

    static constexpr double MAXIMUM_EXTENT = 8192.0; //!< in cells
    static constexpr double MARGIN = 2048.0;         //!< in cells

    /** @param bounds those of the mesh, in model units.
     * @param isFitted whether the grid is fitted to the mesh, rather than made of cells of a given pitch. */
    GridFrame(const BrickGrid& grid, const osg::BoundingBoxd& bounds, bool isFitted);

    /** Convert a position from model units. */
    glm::dvec3 toFrame(const glm::dvec3& position) const;
    /** Round a converted position. */
    glm::vec3 round(const glm::dvec3& position) const;

    /** Whether a triangle, with converted positions, may reach into the grid. */
    bool mayReachGrid(const Corners& corners) const;
    /** Whether a triangle, with converted positions, must be cut before its positions are rounded. */
    bool mustCut(const Corners& corners) const;

    /** The cell of the frame that is cell (0, 0, 0) of the grid. */
    const glm::ivec3& getFirstCell() const { return _firstCell; }

private:
    BrickGrid _grid;
    bool _isFitted;
    bool _isTooLong = false;  // for single precision
    glm::dvec3 _corner{0.0};  // in cells of the grid
    glm::ivec3 _firstCell{0}; // in cells of the frame
};

} // namespace osgLego
