#include <osgLego/cpu/TriangleSlicer.h>

#include <osgLego/cpu/CutPolygon.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

// A line that advances less than this along y, per cell along x, is nearly parallel to x.
constexpr double LEAST_SLOPE = 1e-4;

/** Whether a position on an axis is so far from the planes between cells that rounding can't move it across one. */
bool isAwayFromPlanes(double place)
{
    const double fraction = place - static_cast<double>(static_cast<int>(place));
    return fraction > TriangleSlicer::NEARNESS && fraction < 1.0 - TriangleSlicer::NEARNESS;
}

/** Whether a line with direction (x, y) is nearly, but not exactly, parallel to x: at its intersection with a plane
 * across y, a small error in y is a large error in x. */
bool isNearlyAlongX(double x, double y)
{
    return y != 0.0 && std::abs(y) < LEAST_SLOPE * std::abs(x);
}

/** The fraction of a triangle's area that is below a plane, given the positions of its corners along the normal. */
class FractionBelow
{
public:
    FractionBelow(double a, double b, double c) :
        _lowest(std::min(a, std::min(b, c))), _middle(std::max(std::min(a, b), std::min(std::max(a, b), c))),
        _highest(std::max(a, std::max(b, c)))
    {
    }

    double operator()(double plane) const
    {
        const double below = plane - _lowest;
        const double above = _highest - plane;
        return plane <= _middle ? below * below / ((_middle - _lowest) * (_highest - _lowest))
                                : 1.0 - above * above / ((_highest - _middle) * (_highest - _lowest));
    }

private:
    double _lowest;
    double _middle;
    double _highest;
};

} // namespace

/** Cuts one triangle that spans several rows of cells, by the planes across z first, then y, then x. */
class TriangleSlicer::Cutter
{
public:
    Cutter(const TriangleSlicer& slicer, const glm::ivec3& first, const glm::ivec3& last,
           std::vector<CellPart>& parts) :
        _corners(slicer._corners),
        _minimum(slicer._minimum), _maximum(slicer._maximum), _first(first), _isCut(glm::notEqual(first, last)),
        _parts(parts)
    {
        const glm::dvec3 edge1(glm::dvec3(_corners[1]) - glm::dvec3(_corners[0]));
        const glm::dvec3 edge2(glm::dvec3(_corners[2]) - glm::dvec3(_corners[0]));
        const glm::dvec3 normal = glm::cross(edge1, edge2);
        const double length2 = glm::dot(normal, normal);
        if (length2 > 0.0) chooseProjection(glm::abs(normal), std::sqrt(length2));
        _areCellsKnown = length2 > 0.0 && !(glm::all(_isCut) && mayMagnifyErrors(normal));
    }

    /** @return whether the cells of the parts are certain to be those that the triangle overlaps. */
    bool cut(const glm::ivec3& minimum, const glm::ivec3& maximum)
    {
        CutPolygon triangle;
        for (const glm::vec3& corner : _corners)
            triangle.add(corner);
        cutAcross<2>(triangle, minimum, maximum, _first);
        return _areCellsKnown;
    }

private:
    void chooseProjection(const glm::dvec3& normal, double length)
    {
        _axis = normal.x >= normal.y && normal.x >= normal.z ? 0 : normal.y >= normal.z ? 1 : 2;
        _areaOfProjected = 0.5 * length / normal[static_cast<int>(_axis)];
        // A projection that keeps x is nearly as accurate for areas.
        constexpr double STEEPEST = 1e-3;
        _axisAcrossX = normal.y >= normal.z ? 1 : 2;
        const double size = normal[static_cast<int>(_axisAcrossX)];
        if (size > STEEPEST * length) _areaOfProjectedAcrossX = length / size;
    }

    /** Whether a cut across y may turn an error in y, caused by a cut across z, into a larger error in x. */
    bool mayMagnifyErrors(const glm::dvec3& normal) const
    {
        // Cuts across z create sides perpendicular to the normal.
        if (isNearlyAlongX(normal.y, normal.x)) return true;
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            const glm::dvec3 edge = glm::dvec3(_corners[(corner + 1) % 3]) - glm::dvec3(_corners[corner]);
            if (isNearlyAlongX(edge.x, edge.y)) return true;
        }
        return false;
    }

    /** Cut a polygon across AXIS and the axes before it; those after AXIS have been cut already.
     * @param cell the cell of the polygon along the axes after AXIS. */
    template <int AXIS>
    void cutAcross(const CutPolygon& polygon, const glm::ivec3& minimum, const glm::ivec3& maximum, glm::ivec3 cell)
    {
        const auto goOn = [&](const CutPolygon& part, int place)
        {
            cell[AXIS] = place;
            if constexpr (AXIS > 0)
                cutAcross<AXIS - 1>(part, minimum, maximum, cell);
            else
                _parts.push_back({cell, _areaOfProjected * projectedArea(part, _axis)});
        };
        if (!_isCut[AXIS])
        {
            goOn(polygon, _first[AXIS]);
            return;
        }
        // The corners of an uncut triangle determine its cells exactly; the cells of a polygon depend on the cuts.
        CutExtent extent{_minimum[AXIS], _maximum[AXIS]};
        if (wasCutBefore<AXIS>())
        {
            extent = extentOf<AXIS>(polygon);
            _areCellsKnown = _areCellsKnown && isCellOfEndKnown<AXIS>(polygon, extent.lowest, false) &&
                             isCellOfEndKnown<AXIS>(polygon, extent.highest, true);
        }
        if (AXIS == 0 && _areaOfProjectedAcrossX > 0.0)
            addParts(polygon, extent, minimum.x, maximum.x, cell);
        else
            forEachPart<AXIS>(polygon, extent, minimum[AXIS], maximum[AXIS], goOn);
    }

    /** Add the parts of a polygon in one row of cells along x, without cutting it: the area of each part is the sum of
     * the areas below the polygon's edges in that cell, in a projection that keeps x. */
    void addParts(const CutPolygon& polygon, const CutExtent& extent, int minimum, int maximum, glm::ivec3 cell)
    {
        const int first = std::max(static_cast<int>(extent.lowest), minimum);
        const int last = std::min(static_cast<int>(extent.highest), maximum);
        if (first > last) return;
        CellPart* parts = addEmptyParts(first, last, cell);
        const auto add = [&](int place, double area)
        {
            if (place >= first && place <= last) parts[place - first].area += area;
        };

        const auto across = static_cast<int>(3 - _axisAcrossX);
        const double origin = polygon.corners[0][across];
        const glm::dvec3* from = &polygon.corners[polygon.count - 1];
        for (std::size_t corner = 0; corner < polygon.count; ++corner)
        {
            const glm::dvec3* to = &polygon.corners[corner];
            addBelowEdge({from->x, (*from)[across] - origin}, {to->x, (*to)[across] - origin}, add);
            from = to;
        }
        for (int place = first; place <= last; ++place)
            parts[place - first].area = _areaOfProjectedAcrossX * std::abs(parts[place - first].area);
    }

    CellPart* addEmptyParts(int first, int last, glm::ivec3 cell)
    {
        const std::size_t number = _parts.size();
        _parts.resize(number + static_cast<std::size_t>(last - first + 1));
        CellPart* parts = &_parts[number];
        for (cell.x = first; cell.x <= last; ++cell.x)
            parts[cell.x - first].cell = cell;
        return parts;
    }

    /** Call `add` with the x coordinate of each cell that an edge passes through, and the signed area below the edge
     * there. */
    template <typename Add>
    static void addBelowEdge(glm::dvec2 from, const glm::dvec2& to, const Add& add)
    {
        int place = static_cast<int>(from.x);
        const int end = static_cast<int>(to.x);
        if (place != end)
        {
            const double slope = (to.y - from.y) / (to.x - from.x);
            const int step = place < end ? 1 : -1;
            for (; place != end; place += step)
            {
                const double plane = step > 0 ? place + 1 : place;
                const glm::dvec2 crossing(plane, to.y + slope * (plane - to.x));
                add(place, 0.5 * (from.y + crossing.y) * (crossing.x - from.x));
                from = crossing;
            }
        }
        add(place, 0.5 * (from.y + to.y) * (to.x - from.x));
    }

    template <int AXIS>
    bool wasCutBefore() const
    {
        return (AXIS < 2 && _isCut.z) || (AXIS < 1 && _isCut.y);
    }

    /** Whether rounding can't change the cell, along an axis, that contains the end of a cut polygon. */
    template <int AXIS>
    bool isCellOfEndKnown(const CutPolygon& polygon, double end, bool isHighest) const
    {
        return isAwayFromPlanes(end) || endsAtCorner<AXIS>(polygon, end, isHighest);
    }

    /** Whether a polygon ends exactly at a corner of the triangle, or at an edge perpendicular to the axis: a cut of
     * such an edge does not change its position on the axis. */
    template <int AXIS>
    bool endsAtCorner(const CutPolygon& polygon, double end, bool isHighest) const
    {
        if (std::none_of(_corners.begin(), _corners.end(),
                         [end](const glm::vec3& corner) { return static_cast<double>(corner[AXIS]) == end; }))
            return false;
        glm::dvec3 sum(0.0);
        double count = 0.0;
        for (std::size_t number = 0; number < polygon.count; ++number)
        {
            const glm::dvec3& corner = polygon.corners[number];
            if (std::abs(corner[AXIS] - end) > NEARNESS) continue;
            // If a cut also meets another plane, rounding may have moved the corner to the other side of that plane.
            if (corner[AXIS] != end || countPlanesNear<AXIS>(corner) > 1) return false;
            sum += corner;
            count += 1.0;
        }
        // Upper faces do not belong to a cell: a polygon that only reaches its end on one of them does not reach it
        // inside the cell.
        return !isHighest || countPlanesNear<AXIS>(sum / count) == 0;
    }

    /** The number of axes after AXIS along which a point is near a plane between cells. */
    template <int AXIS>
    static int countPlanesNear(const glm::dvec3& place)
    {
        int count = 0;
        for (int axis = AXIS + 1; axis < 3; ++axis)
            count += isAwayFromPlanes(place[axis]) ? 0 : 1;
        return count;
    }

    const std::array<glm::vec3, 3>& _corners;
    const glm::vec3& _minimum;
    const glm::vec3& _maximum;
    const glm::ivec3& _first; // the cell of `_minimum`
    glm::bvec3 _isCut;
    std::vector<CellPart>& _parts;
    std::size_t _axis = 0;                // the axis along which the triangle's projection is largest
    double _areaOfProjected = 0.0;        // half the triangle's area, divided by the area of that projection
    std::size_t _axisAcrossX = 0;         // y or z: the axis along which the projection is larger
    double _areaOfProjectedAcrossX = 0.0; // the area, divided by that of this projection; 0 if that is too small
    bool _areCellsKnown = false;
};

TriangleSlicer::TriangleSlicer(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) :
    _corners{a, b, c}, _minimum(glm::min(a, glm::min(b, c))), _maximum(glm::max(a, glm::max(b, c)))
{
}

bool TriangleSlicer::slice(const glm::ivec3& minimum, const glm::ivec3& maximum, std::vector<CellPart>& parts) const
{
    const glm::ivec3 first(_minimum);
    const glm::ivec3 last(_maximum);
    if (glm::any(glm::greaterThan(first, maximum)) || glm::any(glm::lessThan(last, minimum))) return true;
    const glm::ivec3 isCut(glm::notEqual(first, last));
    switch (isCut.x + isCut.y + isCut.z)
    {
    case 0:
        parts.push_back({first, getArea()});
        return true;
    case 1:
        sliceRow(isCut.y + 2 * isCut.z, minimum, maximum, parts);
        return true;
    default:
        return Cutter(*this, first, last, parts).cut(minimum, maximum);
    }
}

double TriangleSlicer::getArea() const
{
    const glm::dvec3 origin(_corners[0]);
    return 0.5 * glm::length(glm::cross(glm::dvec3(_corners[1]) - origin, glm::dvec3(_corners[2]) - origin));
}

void TriangleSlicer::sliceRow(int axis, const glm::ivec3& minimum, const glm::ivec3& maximum,
                              std::vector<CellPart>& parts) const
{
    const FractionBelow fractionBelow(_corners[0][axis], _corners[1][axis], _corners[2][axis]);
    const double area = getArea();
    const int last = static_cast<int>(_maximum[axis]);
    const int end = std::min(last, maximum[axis]);
    glm::ivec3 cell(_minimum);
    double before = 0.0;
    if (cell[axis] < minimum[axis])
    {
        cell[axis] = minimum[axis];
        before = fractionBelow(minimum[axis]);
    }
    for (; cell[axis] <= end; ++cell[axis])
    {
        const double upTo = cell[axis] < last ? fractionBelow(cell[axis] + 1) : 1.0;
        parts.push_back({cell, area * (upTo - before)});
        before = upTo;
    }
}

} // namespace osgLego
