#include <osgLego/TriangleSlicer.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

// A direction with a component smaller than this, over its largest, is nearly parallel to an axis' planes.
constexpr double PARALLELITY = 1e-4;

/** A convex polygon: a triangle, with one more corner at most for each of the six planes that it is cut by. */
struct Polygon
{
    std::size_t count = 0;
    std::array<glm::dvec3, 9> corners;

    void add(const glm::dvec3& corner) { corners[count++] = corner; }
};

/** Cut a polygon in two: what is below a plane, and what is on it and above. */
template <int AXIS>
void split(const Polygon& whole, double plane, Polygon& below, Polygon& above)
{
    below.count = 0;
    above.count = 0;
    const glm::dvec3* from = &whole.corners[whole.count - 1];
    bool fromIsBelow = (*from)[AXIS] < plane;
    for (std::size_t corner = 0; corner < whole.count; ++corner)
    {
        const glm::dvec3* to = &whole.corners[corner];
        const bool toIsBelow = (*to)[AXIS] < plane;
        if (fromIsBelow != toIsBelow)
        {
            glm::dvec3 crossing = *from + ((plane - (*from)[AXIS]) / ((*to)[AXIS] - (*from)[AXIS])) * (*to - *from);
            crossing[AXIS] = plane;
            below.add(crossing);
            above.add(crossing);
        }
        (toIsBelow ? below : above).add(*to);
        from = to;
        fromIsBelow = toIsBelow;
    }
}

bool isClear(double place)
{
    const double fraction = place - static_cast<double>(static_cast<int>(place));
    return fraction > TriangleSlicer::NEARNESS && fraction < 1.0 - TriangleSlicer::NEARNESS;
}

struct Extent
{
    double lowest;
    double highest;
};

template <int AXIS>
Extent extentOf(const Polygon& polygon)
{
    Extent extent{polygon.corners[0][AXIS], polygon.corners[0][AXIS]};
    for (std::size_t corner = 1; corner < polygon.count; ++corner)
    {
        extent.lowest = std::min(extent.lowest, polygon.corners[corner][AXIS]);
        extent.highest = std::max(extent.highest, polygon.corners[corner][AXIS]);
    }
    return extent;
}

/** Call `use` with every part of a polygon between planes along an axis, and the number of its cells there.
 * @return false once `use` does. */
template <int AXIS, typename Use>
bool forEachPart(const Polygon& polygon, const Extent& extent, int minimum, int maximum, const Use& use)
{
    const int first = static_cast<int>(extent.lowest);
    const int last = std::min(static_cast<int>(extent.highest), maximum);
    if (first > maximum || static_cast<int>(extent.highest) < minimum) return true;
    if (first == static_cast<int>(extent.highest)) return use(polygon, first);

    std::array<Polygon, 3> parts;
    const Polygon* rest = &polygon;
    std::size_t spare = 0;
    if (first < minimum)
    {
        split<AXIS>(*rest, minimum, parts[2], parts[spare]);
        rest = &parts[spare];
        spare = 1;
    }
    for (int cell = std::max(first, minimum); cell <= last; ++cell)
    {
        if (cell == static_cast<int>(extent.highest)) return use(*rest, cell);
        split<AXIS>(*rest, cell + 1, parts[2], parts[spare]);
        if (!use(parts[2], cell)) return false;
        rest = &parts[spare];
        spare = 1 - spare;
    }
    return true;
}

/** Twice the area of a polygon's projection along an axis. */
double projectedArea(const Polygon& polygon, std::size_t axis)
{
    const auto u = static_cast<int>((axis + 1) % 3);
    const auto v = static_cast<int>((axis + 2) % 3);
    const glm::dvec3& origin = polygon.corners[0];
    double sum = 0.0;
    for (std::size_t corner = 2; corner < polygon.count; ++corner)
    {
        const glm::dvec3 p = polygon.corners[corner - 1] - origin;
        const glm::dvec3 q = polygon.corners[corner] - origin;
        sum += p[u] * q[v] - q[u] * p[v];
    }
    return std::abs(sum);
}

/** Whether a direction is nearly, but not quite, parallel to the planes across one of some axes. */
bool isNearlyParallel(const glm::dvec3& direction, const glm::bvec3& axes)
{
    const glm::dvec3 size = glm::abs(direction);
    const double limit = PARALLELITY * std::max(std::max(size.x, size.y), size.z);
    // One jump for all three, since none can be foreseen.
    const auto isNear = [&](int axis)
    { return unsigned(axes[axis]) & unsigned(size[axis] > 0.0) & unsigned(size[axis] < limit); };
    return (isNear(0) | isNear(1) | isNear(2)) != 0;
}

} // namespace

/** Cuts one triangle, along the planes across z first, then y, then x. */
class TriangleSlicer::Cutter
{
public:
    Cutter(const TriangleSlicer& slicer, const glm::ivec3& first, const glm::ivec3& last,
           std::vector<CellPart>& parts) :
        _corners(slicer._corners),
        _minimum(slicer._minimum), _maximum(slicer._maximum), _isCut(glm::notEqual(first, last)), _parts(parts)
    {
        const glm::dvec3 normal = glm::cross(_corners[1] - _corners[0], _corners[2] - _corners[0]);
        const glm::dvec3 size = glm::abs(normal);
        _axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        _isDelicate = isDelicate(normal);
        if (!_isDelicate) _areaOfProjected = 0.5 * glm::length(normal) / size[static_cast<int>(_axis)];
    }

    /** @return whether everything was decided. */
    bool cut(const glm::ivec3& minimum, const glm::ivec3& maximum)
    {
        if (_isDelicate) return false;
        Polygon triangle;
        for (const glm::dvec3& corner : _corners)
            triangle.add(corner);
        return cutAcross<2>(triangle, minimum, maximum, {0, 0, 0});
    }

private:
    bool isDelicate(const glm::dvec3& normal) const
    {
        if (!(glm::dot(normal, normal) > 0.0)) return true;
        // Of one axis it is the edges that are cut, of several the cuts as well, which lie across the normal.
        const bool areCutsCut = int(_isCut.x) + int(_isCut.y) + int(_isCut.z) > 1;
        return (areCutsCut && isNearlyParallel(normal, glm::bvec3(true))) ||
               isNearlyParallel(_corners[1] - _corners[0], _isCut) ||
               isNearlyParallel(_corners[2] - _corners[1], _isCut) ||
               isNearlyParallel(_corners[0] - _corners[2], _isCut);
    }

    /** Cut what lies in one cell of the axes behind AXIS. @param cell its place along those. */
    template <int AXIS>
    bool cutAcross(const Polygon& polygon, const glm::ivec3& minimum, const glm::ivec3& maximum, glm::ivec3 cell)
    {
        // Of what is still whole the corners tell to the last digit which cells are met; of the rest the cuts do.
        Extent extent{_minimum[AXIS], _maximum[AXIS]};
        if (isCutBehind<AXIS>())
        {
            extent = extentOf<AXIS>(polygon);
            if (!isCertain<AXIS>(polygon, extent.lowest, false) || !isCertain<AXIS>(polygon, extent.highest, true))
                return false;
        }
        return forEachPart<AXIS>(polygon, extent, minimum[AXIS], maximum[AXIS],
                                 [&](const Polygon& part, int place)
                                 {
                                     cell[AXIS] = place;
                                     if constexpr (AXIS > 0) return cutAcross<AXIS - 1>(part, minimum, maximum, cell);
                                     _parts.push_back({cell, _areaOfProjected * projectedArea(part, _axis)});
                                     return true;
                                 });
    }

    template <int AXIS>
    bool isCutBehind() const
    {
        return (AXIS < 2 && _isCut.z) || (AXIS < 1 && _isCut.y);
    }

    /** Whether it is certain in which cell along an axis the end of a polygon lies that was cut along the axes behind.
     */
    template <int AXIS>
    bool isCertain(const Polygon& polygon, double end, bool isHighest) const
    {
        return isClear(end) || isExact<AXIS>(polygon, end, isHighest);
    }

    /** Whether a polygon ends where a corner of the triangle is, or an edge that no cut moves along the axis. */
    template <int AXIS>
    bool isExact(const Polygon& polygon, double end, bool isHighest) const
    {
        if (std::none_of(_corners.begin(), _corners.end(),
                         [end](const glm::dvec3& corner) { return corner[AXIS] == end; }))
            return false;
        glm::dvec3 sum(0.0);
        double count = 0.0;
        for (std::size_t number = 0; number < polygon.count; ++number)
        {
            const glm::dvec3& corner = polygon.corners[number];
            if (std::abs(corner[AXIS] - end) > NEARNESS) continue;
            // Where a cut meets another plane too, rounding may have put it on the other side of that.
            if (corner[AXIS] != end || countUnclear<AXIS>(corner) > 1) return false;
            sum += corner;
            count += 1.0;
        }
        // A cell does not hold its upper faces: what ends there alone does not reach its end inside of the cell.
        return !isHighest || countUnclear<AXIS>(sum / count) == 0;
    }

    /** Of the axes behind AXIS, along how many a place is near a plane. */
    template <int AXIS>
    static int countUnclear(const glm::dvec3& place)
    {
        int count = 0;
        for (int axis = AXIS + 1; axis < 3; ++axis)
            count += isClear(place[axis]) ? 0 : 1;
        return count;
    }

    const std::array<glm::dvec3, 3>& _corners;
    const glm::vec3& _minimum;
    const glm::vec3& _maximum;
    glm::bvec3 _isCut;
    std::vector<CellPart>& _parts;
    std::size_t _axis = 0;         // along which the triangle's projection is largest
    double _areaOfProjected = 0.0; // half the area over that of the projection
    bool _isDelicate = false;
};

TriangleSlicer::TriangleSlicer(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) :
    _corners{a, b, c}, _minimum(glm::min(a, glm::min(b, c))), _maximum(glm::max(a, glm::max(b, c)))
{
}

bool TriangleSlicer::slice(const glm::ivec3& minimum, const glm::ivec3& maximum, std::vector<CellPart>& parts) const
{
    const glm::ivec3 first(_minimum);
    const glm::ivec3 last(_maximum);
    if (first == last)
    {
        if (glm::all(glm::greaterThanEqual(first, minimum)) && glm::all(glm::lessThanEqual(first, maximum)))
            parts.push_back(
                {first, 0.5 * glm::length(glm::cross(_corners[1] - _corners[0], _corners[2] - _corners[0]))});
        return true;
    }
    const std::size_t numBefore = parts.size();
    const bool isDecided = Cutter(*this, first, last, parts).cut(minimum, maximum);
    if (!isDecided) parts.resize(numBefore);
    return isDecided;
}

} // namespace osgLego
