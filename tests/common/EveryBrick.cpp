#include "EveryBrick.h"

#include <osgLego/BrickDimensions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace osgLego
{

namespace
{

constexpr double FAR = std::numeric_limits<double>::infinity();
constexpr double PI = std::numbers::pi;

/** The part of a ray inside half-spaces: an independent way to intersect boxes and studs. */
struct ConvexHit
{
    double begin = 0.0;
    double end = FAR;

    /** Remove the part where dot(normal, origin + t * direction) > limit. */
    void cut(double place, double slope, double limit)
    {
        if (slope == 0.0)
            end = place > limit ? -FAR : end;
        else if (slope > 0.0)
            end = std::min(end, (limit - place) / slope);
        else
            begin = std::max(begin, (limit - place) / slope);
    }
    void merge(std::optional<double>& nearest) const
    {
        if (begin <= end && (!nearest || begin < *nearest)) nearest = begin;
    }
};

} // namespace

std::optional<double> askEveryBrick(const BrickModel& model, const glm::dvec3& origin, const glm::dvec3& direction)
{
    const glm::dvec3 extent = model.getGrid().cellSize / model.getGrid().getPitch();
    const int up = model.getGrid().getUpIndex();
    std::optional<double> nearest;
    for (const Brick& brick : model.getBricks())
    {
        const glm::dvec3 corner = extent * glm::dvec3(brick.cell[0], brick.cell[1], brick.cell[2]);
        ConvexHit box;
        for (int axis = 0; axis < 3; ++axis)
        {
            box.cut(origin[axis], direction[axis], corner[axis] + extent[axis]);
            box.cut(-origin[axis], -direction[axis], -corner[axis]);
        }
        box.merge(nearest);
        if (!(brick.openSides & (SIDE_RIGHT << (2 * up)))) continue;

        ConvexHit stud;
        const double foot = corner[up] + extent[up];
        stud.cut(origin[up], direction[up], foot + BrickDimensions::STUD_HEIGHT);
        stud.cut(-origin[up], -direction[up], -foot);
        for (int side = 0; side < 16; ++side)
        {
            glm::dvec3 normal(0.0);
            normal[(up + 1) % 3] = std::cos(2.0 * PI * (side + 0.5) / 16.0);
            normal[(up + 2) % 3] = std::sin(2.0 * PI * (side + 0.5) / 16.0);
            stud.cut(glm::dot(normal, origin - corner - 0.5), glm::dot(normal, direction),
                     BrickDimensions::STUD_RADIUS * std::cos(PI / 16.0));
        }
        stud.merge(nearest);
    }
    return nearest;
}

} // namespace osgLego
