#include <osgLego/cpu/TriangleOverlap.h>

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace osgLego
{

namespace
{

// Up to this many candidate cells are tried one by one, more are halved first.
constexpr int DIRECT_CANDIDATES = 27;
// In cells; boxes of many cells are judged generously, their cells exactly.
constexpr double GENEROSITY = 1e-9;
// An axis this short comes from a sliver or an edge along an axis, and tells nothing.
constexpr double SHORTEST_AXIS = 1e-9;

using Corners = std::array<glm::dvec3, 3>;

/** Twice the vector area between the origin and the part of the segment pq that lies in the unit cell, faces included.
 */
glm::dvec3 sweptInCell(const glm::dvec3& p, const glm::dvec3& q)
{
    const glm::dvec3 along = q - p;
    double begin = 0.0;
    double end = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
        if (along[axis] == 0.0)
        {
            if (p[axis] < 0.0 || p[axis] > 1.0) return glm::dvec3(0.0);
            continue;
        }
        const double lower = -p[axis] / along[axis];
        const double upper = (1.0 - p[axis]) / along[axis];
        begin = std::max(begin, std::min(lower, upper));
        end = std::min(end, std::max(lower, upper));
    }
    return begin < end ? glm::cross(p + begin * along, p + end * along) : glm::dvec3(0.0);
}

/** The chord along which the plane of a face cuts a triangle, from where its outline leaves the inner side to where it
 * comes back; nothing where the plane misses it.
 * @param face 0 for the lower face of an axis, 1 for the upper. */
glm::dvec3 sweptOnFace(const Corners& corners, int axis, double face)
{
    glm::dvec3 leave(0.0);
    glm::dvec3 enter(0.0);
    bool isCut = false;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
        const glm::dvec3& from = corners[corner];
        const glm::dvec3& to = corners[(corner + 1) % 3];
        const double here = face == 0.0 ? from[axis] : 1.0 - from[axis];
        const double there = face == 0.0 ? to[axis] : 1.0 - to[axis];
        if ((here >= 0.0) == (there >= 0.0)) continue;
        glm::dvec3 crossing = glm::mix(from, to, here / (here - there));
        crossing[axis] = face;
        (here >= 0.0 ? leave : enter) = crossing;
        isCut = true;
    }
    return isCut ? sweptInCell(leave, enter) : glm::dvec3(0.0);
}

} // namespace

TriangleOverlap::TriangleOverlap(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) :
    _corners{a, b, c}, _minimum(glm::min(a, glm::min(b, c))), _maximum(glm::max(a, glm::max(b, c)))
{
    const std::array<glm::dvec3, 3> edges{b - a, c - b, a - c};
    _axes[0] = makeAxis(glm::cross(edges[0], edges[1]));
    std::size_t next = 1;
    for (const glm::dvec3& edge : edges)
        for (int axis = 0; axis < 3; ++axis)
        {
            glm::dvec3 unit(0.0);
            unit[axis] = 1.0;
            _axes[next++] = makeAxis(glm::cross(unit, edge));
        }
}

TriangleOverlap::Axis TriangleOverlap::makeAxis(const glm::dvec3& direction) const
{
    Axis axis;
    axis.direction = direction;
    const std::array<double, 3> places{glm::dot(direction, _corners[0]), glm::dot(direction, _corners[1]),
                                       glm::dot(direction, _corners[2])};
    axis.triangleMinimum = *std::min_element(places.begin(), places.end());
    axis.triangleMaximum = *std::max_element(places.begin(), places.end());
    const glm::dvec3 upward = glm::max(direction, glm::dvec3(0.0));
    const glm::dvec3 downward = glm::min(direction, glm::dvec3(0.0));
    axis.cellMinimum = downward.x + downward.y + downward.z;
    axis.cellMaximum = upward.x + upward.y + upward.z;
    axis.minimumIsOpen = downward != glm::dvec3(0.0);
    axis.maximumIsOpen = upward != glm::dvec3(0.0);
    return axis;
}

bool TriangleOverlap::overlaps(const glm::ivec3& cell) const
{
    const glm::dvec3 corner(cell);
    if (glm::any(glm::lessThan(_maximum, corner)) || glm::any(glm::greaterThanEqual(_minimum, corner + 1.0)))
        return false;
    for (const Axis& axis : _axes)
    {
        const double shift = glm::dot(axis.direction, corner);
        const double cellMinimum = axis.cellMinimum + shift;
        const double cellMaximum = axis.cellMaximum + shift;
        if (axis.triangleMinimum > cellMaximum || axis.triangleMaximum < cellMinimum) return false;
        if (axis.triangleMinimum == cellMaximum && axis.maximumIsOpen) return false;
        if (axis.triangleMaximum == cellMinimum && axis.minimumIsOpen) return false;
    }
    return true;
}

double TriangleOverlap::getMargin(const glm::ivec3& cell) const
{
    const glm::dvec3 corner(cell);
    const glm::dvec3 gaps = glm::max(_minimum - (corner + 1.0), corner - _maximum);
    double gap = std::max({gaps.x, gaps.y, gaps.z});
    for (const Axis& axis : _axes)
    {
        const double length = glm::length(axis.direction);
        if (length < SHORTEST_AXIS) continue;
        const double shift = glm::dot(axis.direction, corner);
        gap = std::max(gap, std::max(axis.triangleMinimum - axis.cellMaximum - shift,
                                     axis.cellMinimum + shift - axis.triangleMaximum) /
                                length);
    }
    return -gap;
}

double TriangleOverlap::getAreaInside(const glm::ivec3& cell) const
{
    // By Stokes' theorem: the outline of the part inside is made of pieces of the triangle's edges and of its chords
    // with the planes of the cell's faces.
    const glm::dvec3 origin(cell);
    const Corners corners{_corners[0] - origin, _corners[1] - origin, _corners[2] - origin};
    glm::dvec3 sum =
        sweptInCell(corners[0], corners[1]) + sweptInCell(corners[1], corners[2]) + sweptInCell(corners[2], corners[0]);
    for (int axis = 0; axis < 3; ++axis)
    {
        if (_minimum[axis] < origin[axis]) sum += sweptOnFace(corners, axis, 0.0);
        if (_maximum[axis] > origin[axis] + 1.0) sum += sweptOnFace(corners, axis, 1.0);
    }
    return 0.5 * glm::length(sum);
}

glm::dvec3 TriangleOverlap::findNearest(const glm::dvec3& point) const
{
    // Corners may coincide, once they are rounded to floats: no edge is asked that has no length.
    const auto& [a, b, c] = _corners;
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double d1 = glm::dot(ab, point - a);
    const double d2 = glm::dot(ac, point - a);
    if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};

    const double d3 = glm::dot(ab, point - b);
    const double d4 = glm::dot(ac, point - b);
    if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};

    const double shareC = d1 * d4 - d3 * d2;
    if (shareC <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3)
    {
        const double v = d1 / (d1 - d3);
        return {1.0 - v, v, 0.0};
    }

    const double d5 = glm::dot(ab, point - c);
    const double d6 = glm::dot(ac, point - c);
    if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};

    const double shareB = d5 * d2 - d1 * d6;
    if (shareB <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6)
    {
        const double w = d2 / (d2 - d6);
        return {1.0 - w, 0.0, w};
    }

    const double shareA = d3 * d6 - d5 * d4;
    if (shareA <= 0.0 && d4 >= d3 && d5 >= d6 && (d4 > d3 || d5 > d6))
    {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - w, w};
    }

    const double sum = shareA + shareB + shareC;
    return sum > 0.0 ? glm::dvec3(shareA, shareB, shareC) / sum : glm::dvec3(1.0, 0.0, 0.0);
}

void TriangleOverlap::findCells(const glm::ivec3& dimensions, std::vector<glm::ivec3>& cells) const
{
    findCells(glm::ivec3(0), dimensions - 1, cells);
}

void TriangleOverlap::findCells(const glm::ivec3& minimum, const glm::ivec3& maximum,
                                std::vector<glm::ivec3>& cells) const
{
    const glm::ivec3 first = glm::max(glm::ivec3(glm::floor(_minimum)), minimum);
    const glm::ivec3 last = glm::min(glm::ivec3(glm::floor(_maximum)), maximum);
    if (glm::any(glm::greaterThan(first, last))) return;
    findCellsBetween(first, last, cells);
}

bool TriangleOverlap::mayOverlap(const glm::ivec3& minimum, const glm::ivec3& maximum) const
{
    const glm::dvec3 corner(minimum);
    const glm::dvec3 size(maximum - minimum + 1);
    for (const Axis& axis : _axes)
    {
        const double shift = glm::dot(axis.direction, corner);
        const double slack = GENEROSITY * (glm::dot(glm::abs(axis.direction), size) + std::abs(shift));
        const double low = shift + glm::dot(glm::min(axis.direction, glm::dvec3(0.0)), size) - slack;
        const double high = shift + glm::dot(glm::max(axis.direction, glm::dvec3(0.0)), size) + slack;
        if (axis.triangleMinimum > high || axis.triangleMaximum < low) return false;
    }
    return true;
}

void TriangleOverlap::findCellsBetween(const glm::ivec3& minimum, const glm::ivec3& maximum,
                                       std::vector<glm::ivec3>& cells) const
{
    const glm::ivec3 size = maximum - minimum + 1;
    if (static_cast<double>(size.x) * size.y * size.z <= DIRECT_CANDIDATES)
    {
        glm::ivec3 cell;
        for (cell.z = minimum.z; cell.z <= maximum.z; ++cell.z)
            for (cell.y = minimum.y; cell.y <= maximum.y; ++cell.y)
                for (cell.x = minimum.x; cell.x <= maximum.x; ++cell.x)
                    if (overlaps(cell)) cells.push_back(cell);
        return;
    }

    if (!mayOverlap(minimum, maximum)) return;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    glm::ivec3 lowerMaximum = maximum;
    lowerMaximum[axis] = minimum[axis] + size[axis] / 2 - 1;
    glm::ivec3 upperMinimum = minimum;
    upperMinimum[axis] = lowerMaximum[axis] + 1;
    findCellsBetween(minimum, lowerMaximum, cells);
    findCellsBetween(upperMinimum, maximum, cells);
}

} // namespace osgLego
