#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Which cells of the unit grid a triangle overlaps, and how: the ground truth of voxelization, in double precision.
 *
 * A cell is half-open: it holds its three lower faces and not its three upper ones, so that a surface on the boundary
 * of two cells belongs to one of them. The test is Akenine-Moller's (Fast 3D Triangle-Box Overlap Testing, 2001) on
 * thirteen axes; a touch at the end of an axis counts only where the cell's own corner there counts.
 *
 * Usage:
 *
 *     const osgLego::TriangleOverlap overlap(a, b, c);
 *     overlap.findCells(grid.dimensions, cells);
 *
 * Immutable, free of GL; every function may be called from any thread.
 */
class TriangleOverlap
{
public:
    /** @param a, b, c corners in cell units. */
    TriangleOverlap(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

    /** Whether the triangle and the cell have a point in common. */
    bool overlaps(const glm::ivec3& cell) const;

    /** How far, in cells, the triangle would have to move to stop overlapping the cell; if it does not overlap it,
     * how far, as a negative number, to begin (a lower bound of that distance). */
    double getMargin(const glm::ivec3& cell) const;

    /** Append every overlapped cell from (0, 0, 0) to below `dimensions`; each once, in an order that depends on the
     * triangle alone. */
    void findCells(const glm::ivec3& dimensions, std::vector<glm::ivec3>& cells) const;
    /** The same for the cells from `minimum` to `maximum`, both included. */
    void findCells(const glm::ivec3& minimum, const glm::ivec3& maximum, std::vector<glm::ivec3>& cells) const;

private:
    // The triangle's normal, and each edge crossed with each axis; the three faces' axes are the bounds.
    static constexpr int NUM_AXES = 10;

    struct Axis
    {
        glm::dvec3 direction{0.0};
        double triangleMinimum = 0.0;
        double triangleMaximum = 0.0;
        double cellMinimum = 0.0; // of the cell at the origin
        double cellMaximum = 0.0;
        bool minimumIsOpen = false; // the cell ends there in a corner that is not its own
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
