#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A convex polygon: a triangle cut by up to six planes, each of which adds at most one corner. */
struct CutPolygon
{
    std::size_t count = 0;
    std::array<glm::dvec3, 9> corners;

    void add(const glm::dvec3& corner) { corners[count++] = corner; }
};

/** Cut a polygon in two: the part below a plane, and the part on or above it. */
template <int AXIS>
void cut(const CutPolygon& whole, double plane, CutPolygon& below, CutPolygon& above)
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

/** The positions of the ends of a polygon along an axis. */
struct CutExtent
{
    double lowest;
    double highest;
};

template <int AXIS>
CutExtent extentOf(const CutPolygon& polygon)
{
    CutExtent extent{polygon.corners[0][AXIS], polygon.corners[0][AXIS]};
    for (std::size_t corner = 1; corner < polygon.count; ++corner)
    {
        extent.lowest = std::min(extent.lowest, polygon.corners[corner][AXIS]);
        extent.highest = std::max(extent.highest, polygon.corners[corner][AXIS]);
    }
    return extent;
}

/** Cut a polygon by the planes across an axis. Call `use` with every part and the coordinate of its cells. */
template <int AXIS, typename Use>
void forEachPart(const CutPolygon& polygon, const CutExtent& extent, int minimum, int maximum, const Use& use)
{
    const int first = static_cast<int>(extent.lowest);
    const int end = static_cast<int>(extent.highest);
    if (first > maximum || end < minimum) return;
    if (first == end)
    {
        use(polygon, first);
        return;
    }

    std::array<CutPolygon, 3> parts;
    const CutPolygon* rest = &polygon;
    std::size_t spare = 0;
    if (first < minimum)
    {
        cut<AXIS>(*rest, minimum, parts[2], parts[spare]);
        rest = &parts[spare];
        spare = 1;
    }
    for (int cell = std::max(first, minimum); cell <= std::min(end - 1, maximum); ++cell)
    {
        cut<AXIS>(*rest, cell + 1, parts[2], parts[spare]);
        use(parts[2], cell);
        rest = &parts[spare];
        spare = 1 - spare;
    }
    if (end <= maximum) use(*rest, end);
}

/** Twice the area of a polygon's projection along an axis. */
inline double projectedArea(const CutPolygon& polygon, std::size_t axis)
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

} // namespace osgLego
