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

struct Extent
{
    double lowest;
    double highest;

    bool isClear() const { return isClear(lowest) && isClear(highest); }

private:
    static bool isClear(double place)
    {
        const double fraction = place - static_cast<double>(static_cast<int>(place));
        return fraction > TriangleSlicer::NEARNESS && fraction < 1.0 - TriangleSlicer::NEARNESS;
    }
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

bool isNearlyParallel(const glm::dvec3& direction)
{
    const glm::dvec3 size = glm::abs(direction);
    const double limit = PARALLELITY * std::max({size.x, size.y, size.z});
    return (size.x < limit && size.x > 0.0) || (size.y < limit && size.y > 0.0) || (size.z < limit && size.z > 0.0);
}

} // namespace

TriangleSlicer::TriangleSlicer(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) :
    _corners{a, b, c}, _minimum(glm::min(a, glm::min(b, c))), _maximum(glm::max(a, glm::max(b, c)))
{
    const glm::dvec3 ab = _corners[1] - _corners[0];
    const glm::dvec3 ac = _corners[2] - _corners[0];
    const glm::dvec3 normal = glm::cross(ab, ac);
    const glm::dvec3 size = glm::abs(normal);
    _axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double largest = size[static_cast<int>(_axis)];
    _isDelicate = !(largest > 0.0) || isNearlyParallel(normal) || isNearlyParallel(ab) || isNearlyParallel(ac) ||
                  isNearlyParallel(ac - ab);
    if (!_isDelicate) _areaOfProjected = 0.5 * glm::length(normal) / largest;
}

bool TriangleSlicer::slice(const glm::ivec3& minimum, const glm::ivec3& maximum, std::vector<CellPart>& parts) const
{
    if (_isDelicate) return false;
    const std::size_t numBefore = parts.size();
    Polygon triangle;
    for (const glm::dvec3& corner : _corners)
        triangle.add(corner);

    // Of the layers the corners tell, to the last digit, which are met; of rows and cells the cuts do.
    const bool isDecided =
        forEachPart<2>(triangle, {_minimum.z, _maximum.z}, minimum.z, maximum.z,
                       [&](const Polygon& layer, int z)
                       {
                           const Extent rows = extentOf<1>(layer);
                           if (!rows.isClear()) return false;
                           return forEachPart<1>(
                               layer, rows, minimum.y, maximum.y,
                               [&](const Polygon& row, int y)
                               {
                                   const Extent cells = extentOf<0>(row);
                                   if (!cells.isClear()) return false;
                                   return forEachPart<0>(
                                       row, cells, minimum.x, maximum.x,
                                       [&](const Polygon& part, int x)
                                       {
                                           parts.push_back({{x, y, z}, _areaOfProjected * projectedArea(part, _axis)});
                                           return true;
                                       });
                               });
                       });
    if (!isDecided) parts.resize(numBefore);
    return isDecided;
}

} // namespace osgLego
