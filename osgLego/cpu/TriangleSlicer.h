#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The part of a triangle in one cell. */
struct CellPart
{
    glm::ivec3 cell{0};
    double area = 0.0; //!< in cell units squared
};

/** Cuts a triangle along the planes between cells, to find the cells that it overlaps and its area in each, at the cost
 * of one cut for each further cell.
 *
 * The cells are those of TriangleOverlap, which tests each cell separately and takes several times as long. Where
 * rounding could change the cells, slice() returns false, and TriangleOverlap must determine them; the areas found here
 * are still usable.
 *
 * Rounding matters in the following case. The triangle is cut across z first, then y, then x. Its corners are in single
 * precision, so the cells along z are exact. Each polygon left by a cut covers, along the next axis, the cells from its
 * lowest to its highest end.
 *
 *     y = 2              3              4
 *         |              |              |
 *         |  p-----------|-----------.  |
 *         |   \          |            `-|-.
 *         |    \         |              |  `-q
 *         |     \        |         _,-'-|'
 *         |      \       |   _,--'      |
 *         |       \__,---|-'            |
 *         |       r      |              |
 *       >| |<          >| |<          >| |<  NEARNESS
 *
 * The drawing shows such a polygon, seen along z; the cut created its side pq. The lowest end, p, is farther than
 * NEARNESS from every plane, so that a rounding error of about 1e-12 cells can't move it into another cell: the polygon
 * is certain to meet the cells from y = 2 on. Likewise, because of the highest end, q, it is certain to meet the cells
 * up to y = 5. If q were within NEARNESS of y = 4, this would be certain only if q were exact: a corner of the
 * triangle, or a point on an edge along which y is constant.
 *
 * The rounding error is about 1e-12 cells because differences of coordinates up to 4096 cells are exact in double
 * precision, so that a cut of one of the triangle's edges is within that distance of its true position; each further
 * cut of the rest of an edge adds the same error. The line pq has this error in y, too. A cut of pq across y turns it
 * into an error in x, multiplied by the number of cells that pq advances along x per cell along y. If that number
 * exceeds 1e4, the cells are uncertain as well. Cuts across x only determine areas.
 *
 * Rounding in TriangleOverlap, which grows with the triangle, may make it miss a mere touch that cutting finds. Of
 * triangles whose corners were placed a few floating-point steps beside planes, one in a thousand differed if they
 * spanned hundreds of cells, and one in a million if they spanned at most twenty.
 *
 * Usage:
 *
 *     if (!osgLego::TriangleSlicer(a, b, c).slice(minimum, maximum, parts)) ... // TriangleOverlap(a, b, c)
 *
 * Immutable; uses no GL. Every function may be called from any thread.
 */
class TriangleSlicer
{
public:
    static constexpr double NEARNESS = 1e-6; //!< in cells

    /** @param a, b, c corners in cell units, 0 to 4096. */
    TriangleSlicer(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

    /** Append the parts in the cells from `minimum` to `maximum`, both inclusive, ordered by z, then y, then x.
     * @return whether their cells are certain. If not, TriangleOverlap must determine the cells: it may add or remove
     * cells in which the area is below 1e-6. */
    bool slice(const glm::ivec3& minimum, const glm::ivec3& maximum, std::vector<CellPart>& parts) const;

private:
    class Cutter;

    double getArea() const;
    void sliceRow(int axis, const glm::ivec3& minimum, const glm::ivec3& maximum, std::vector<CellPart>& parts) const;

    std::array<glm::vec3, 3> _corners;
    glm::vec3 _minimum;
    glm::vec3 _maximum;
};

} // namespace osgLego
