#include <osgLego/stability/ContactPoints.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace osgLego
{

namespace
{

constexpr double OUTWARDS = 0.25;
constexpr double INWARDS = -0.125;

/** Add the points at one stud. @param outside the directions, -1 or 1, to the nearest sides of the part. */
void addPoints(const Eigen::Vector2d& stud, const Eigen::Vector2d& outside, const Eigen::Vector2i& size,
               std::vector<Eigen::Vector2d>& points)
{
    const auto add = [&](double x, double y) { points.emplace_back(stud + Eigen::Vector2d(x, y)); };
    if (size.minCoeff() == 1)
    {
        for (const double step : {-OUTWARDS, OUTWARDS})
        {
            add(step, 0.0);
            add(0.0, step);
        }
    }
    else if (size.x() == size.y())
    {
        add(OUTWARDS * outside.x(), 0.0);
        add(0.0, OUTWARDS * outside.y());
        add(INWARDS * outside.x(), INWARDS * outside.y());
    }
    else if (size.x() < size.y())
    {
        add(OUTWARDS * outside.x(), 0.0);
        add(INWARDS * outside.x(), INWARDS);
        add(INWARDS * outside.x(), -INWARDS);
    }
    else
    {
        add(0.0, OUTWARDS * outside.y());
        add(INWARDS, INWARDS * outside.y());
        add(-INWARDS, INWARDS * outside.y());
    }
}

/** Twice the area of the triangle of three points, positive if they turn left. */
double turnOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

} // namespace

Eigen::Vector3d toPitches(const glm::ivec3& corner)
{
    constexpr double PLATE_HEIGHT = 0.4;
    return {1.0 * corner.x, 1.0 * corner.y, PLATE_HEIGHT * corner.z};
}

std::vector<Eigen::Vector2d> findStudPoints(const Eigen::Vector2d& halfSize, const Eigen::Vector2d& center,
                                            const Eigen::Vector2i& size)
{
    std::vector<Eigen::Vector2d> points;
    for (double y = 0.5 - halfSize.y(); y < halfSize.y(); y += 1.0)
        for (double x = 0.5 - halfSize.x(); x < halfSize.x(); x += 1.0)
            addPoints({x, y}, {std::copysign(1.0, x - center.x()), std::copysign(1.0, y - center.y())}, size, points);
    return points;
}

std::vector<Eigen::Vector2d> findHull(std::vector<Eigen::Vector2d> points)
{
    std::sort(points.begin(), points.end(),
              [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
              { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
    std::vector<Eigen::Vector2d> hull;
    // The lower side from left to right, and the upper side back.
    for (const bool isUpper : {false, true})
    {
        if (isUpper) std::reverse(points.begin(), points.end());
        const std::size_t start = hull.size();
        for (const Eigen::Vector2d& point : points)
        {
            while (hull.size() >= start + 2 && turnOf(hull[hull.size() - 2], hull.back(), point) <= 0.0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
    }
    return hull;
}

} // namespace osgLego
