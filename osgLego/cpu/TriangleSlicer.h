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
 * numbers are so near to each other that cutting could come to another end, TriangleOverlap is to be asked which cells
 * there are, and the areas found here are still good. So it is where a cut ends within NEARNESS of another plane, and
 * it can't be shown that this is what it does exactly.
 *
 * Why that is enough: cuts go across z first, then y, then x. Corners are floats, so which cells along z are met is
 * exact. A cut of the triangle's own edges lies within 1e-12 cells of where it ought to, as differences of coordinates
 * of at most 4096 cells lose nothing in double precision; each further cut of the rest of an edge adds as much. A cut
 * of what is cut already does too, times how fast x changes with y along it; where that is by more than 1e4, nothing is
 * certain either. Cuts across x find areas alone.
 *
 * A mere touch TriangleOverlap may lose by rounding, which grows with the triangle, and cutting knows it: of triangles
 * whose corners were put a few steps of a float beside planes, one in a thousand differed where they reached over
 * hundreds of cells, and one in a million within twenty.
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
