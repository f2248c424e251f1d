#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Determines the cells of the unit grid that a triangle overlaps: the ground truth of voxelization, in double
 * precision.
 *
 * A cell is half-open: its three lower faces belong to it and its three upper faces do not, so that a surface on the
 * boundary between two cells belongs to one of them. The test is Akenine-Moller's (Fast 3D Triangle-Box Overlap
 * Testing, 2001) on thirteen axes. Where the projections of triangle and cell on an axis merely touch, they overlap
 * only if the cell's corner there belongs to the cell.
 *
 * Usage:
 *
 *     const osgLego::TriangleOverlap overlap(a, b, c);
 *     overlap.findCells(grid.dimensions, cells);
 *
 * Immutable; uses no GL. Every function may be called from any thread.
 */
class TriangleOverlap
{
public:
    /** @param a, b, c corners in cell units. */
    TriangleOverlap(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

    /** Whether the triangle and the cell have a point in common. */
    bool overlaps(const glm::ivec3& cell) const;

    /** The distance, in cells, by which the triangle would have to move to stop overlapping the cell. If it does not
     * overlap the cell: minus a lower bound of the distance between them. */
    double getMargin(const glm::ivec3& cell) const;

    /** Append every overlapped cell from (0, 0, 0) to `dimensions`, exclusive; each once, in an order that depends only
     * on the triangle. */
    void findCells(const glm::ivec3& dimensions, std::vector<glm::ivec3>& cells) const;
    /** The same for the cells from `minimum` to `maximum`, both inclusive. */
    void findCells(const glm::ivec3& minimum, const glm::ivec3& maximum, std::vector<glm::ivec3>& cells) const;

private:
    // The triangle's normal, and the cross product of each edge with each axis. The bounds test the three face normals.
    static constexpr int NUM_AXES = 10;

    struct Axis
    {
        glm::dvec3 direction{0.0};
        double triangleMinimum = 0.0;
        double triangleMaximum = 0.0;
        double cellMinimum = 0.0; // of the cell at the origin
        double cellMaximum = 0.0;
        bool minimumIsOpen = false; // the corner of the cell there does not belong to the cell
        bool maximumIsOpen = false;
    };

    Axis makeAxis(const glm::dvec3& direction) const;
    bool mayOverlap(const glm::ivec3& minimum, const glm::ivec3& maximum) const;
    void findCellsBetween(const glm::ivec3& minimum, const glm::ivec3& maximum, std::vector<glm::ivec3>& cells) const;

    std::array<glm::dvec3, 3> _corners;
    glm::dvec3 _minimum;
    glm::dvec3 _maximum;
    std::array<Axis, NUM_AXES> _axes;
};

} // namespace osgLego
