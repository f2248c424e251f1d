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

// A box of up to this many cells is tested cell by cell; a larger one is halved first.
constexpr int DIRECT_CANDIDATES = 27;
// In cells. It makes the test of a box of several cells conservative; single cells are tested exactly.
constexpr double BOX_SLACK = 1e-9;
// A shorter axis comes from a sliver, or from an edge along an axis, and separates nothing.
constexpr double SHORTEST_AXIS = 1e-9;

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
        const double slack = BOX_SLACK * (glm::dot(glm::abs(axis.direction), size) + std::abs(shift));
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
