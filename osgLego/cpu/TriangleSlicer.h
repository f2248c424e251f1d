#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The part of a triangle that lies in one cell. */
struct CellPart
{
    glm::ivec3 cell{0};
    double area = 0.0; //!< in cell units squared
};

/** Cuts a triangle along the planes between cells: which cells it overlaps, and the area in each, at the cost of one
 * cut for each further cell.
 *
 * The cells are those of TriangleOverlap, which decides every cell for itself and takes several times as long. Where
 * rounding could change which cells the cuts find, TriangleOverlap is to be asked for the cells; the areas found here
 * are still good.
 *
 * Where that is: cuts go across z first, then y, then x. Corners are floats, so which cells are met along z is exact.
 * Each cut leaves a polygon, which meets the cells from its lowest to its highest end along the next axis.
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
 * The drawing shows such a polygon along z: the cut made its side pq. The lowest end, p, is farther than NEARNESS from
 * every plane, so rounding, of 1e-12 cells, can't move it into another cell: it is known that the cells from y = 2 on
 * are met. The same holds for the highest end, q, and the cells up to y = 5. If q were within NEARNESS of y = 4, it
 * would be known only if q is exact: a corner of the triangle, or on an edge along which y does not change.
 *
 * Why rounding is of 1e-12 cells: a cut of the triangle's own edges lies within that of its true place, as differences
 * of coordinates of at most 4096 cells lose nothing in double precision, and each further cut of the rest of an edge
 * adds as much. The line pq has that error in y, too, and a cut of it across y has it in x, times how far x goes
 * for each cell along y. Where that is more than 1e4 cells, the cells are not known either. Cuts across x find areas
 * alone.
 *
 * TriangleOverlap may miss a mere touch by rounding, which grows with the triangle, where cutting finds it: of
 * triangles whose corners were put a few steps of a float beside planes, one in a thousand differed where they reached
 * over hundreds of cells, and one in a million within twenty.
 *
 * Usage:
 *
 *     if (!osgLego::TriangleSlicer(a, b, c).slice(minimum, maximum, parts)) ... // TriangleOverlap(a, b, c)
 *
 * Immutable, free of GL; every function may be called from any thread.
 */
class TriangleSlicer
{
public:
    static constexpr double NEARNESS = 1e-6; //!< in cells

    /** @param a, b, c corners in cell units, 0 to 4096. */
    TriangleSlicer(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

    /** Append the parts in the cells from `minimum` to `maximum`, both included, ordered by z, then y, then x.
     * @return whether these are the cells; if not, TriangleOverlap is to be asked: it may know others beside, of areas
     * below 1e-6, and not know some of such areas. */
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
