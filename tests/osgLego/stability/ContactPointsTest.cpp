#include <osgLego/stability/ContactPoints.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Points = std::vector<Eigen::Vector2d>;
using PointSet = std::multiset<std::pair<double, double>>;

PointSet toSet(const Points& points)
{
    PointSet set;
    for (const Eigen::Vector2d& point : points)
        set.emplace(point.x(), point.y());
    return set;
}

TEST(ContactPoints, APartOneStudWideHasFourPointsAtEachStud)
{
    EXPECT_EQ(toSet(findStudPoints({0.5, 0.5}, {0.0, 0.0}, {1, 1})),
              (PointSet{{-0.25, 0.0}, {0.25, 0.0}, {0.0, -0.25}, {0.0, 0.25}}));
    // The last two studs of a part 1 x 4.
    EXPECT_EQ(toSet(findStudPoints({0.5, 1.0}, {0.0, -1.0}, {1, 4})), (PointSet{{-0.25, -0.5},
                                                                                {0.25, -0.5},
                                                                                {0.0, -0.75},
                                                                                {0.0, -0.25},
                                                                                {-0.25, 0.5},
                                                                                {0.25, 0.5},
                                                                                {0.0, 0.25},
                                                                                {0.0, 0.75}}));
}

TEST(ContactPoints, ASquarePartHasTwoPointsOutwardsAndOneInwardsAtEachStud)
{
    EXPECT_EQ(toSet(findStudPoints({1.0, 1.0}, {0.0, 0.0}, {2, 2})), (PointSet{{-0.75, -0.5},
                                                                               {-0.5, -0.75},
                                                                               {-0.375, -0.375},
                                                                               {0.75, -0.5},
                                                                               {0.5, -0.75},
                                                                               {0.375, -0.375},
                                                                               {-0.75, 0.5},
                                                                               {-0.5, 0.75},
                                                                               {-0.375, 0.375},
                                                                               {0.75, 0.5},
                                                                               {0.5, 0.75},
                                                                               {0.375, 0.375}}));
    // One stud at its upper right.
    EXPECT_EQ(toSet(findStudPoints({0.5, 0.5}, {-0.5, -0.5}, {2, 2})),
              (PointSet{{0.25, 0.0}, {0.0, 0.25}, {-0.125, -0.125}}));
}

TEST(ContactPoints, APartTwoStudsWideHasOnePointOutwardsAndTwoInwardsAtEachStud)
{
    // One stud at the near left corner of a part 4 x 2, and of a part 2 x 4.
    EXPECT_EQ(toSet(findStudPoints({0.5, 0.5}, {1.5, 0.5}, {4, 2})),
              (PointSet{{0.0, -0.25}, {-0.125, 0.125}, {0.125, 0.125}}));
    EXPECT_EQ(toSet(findStudPoints({0.5, 0.5}, {0.5, 1.5}, {2, 4})),
              (PointSet{{-0.25, 0.0}, {0.125, -0.125}, {0.125, 0.125}}));
    // One at the far right corner.
    EXPECT_EQ(toSet(findStudPoints({0.5, 0.5}, {-1.5, -0.5}, {4, 2})),
              (PointSet{{0.0, 0.25}, {-0.125, -0.125}, {0.125, -0.125}}));
    EXPECT_EQ(toSet(findStudPoints({0.5, 0.5}, {-0.5, -1.5}, {2, 4})),
              (PointSet{{0.25, 0.0}, {-0.125, -0.125}, {-0.125, 0.125}}));
    EXPECT_EQ(findStudPoints({4.0, 1.0}, {0.0, 0.0}, {8, 2}).size(), 48u);
}

double turnOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/** The points that are alone the farthest in some direction. @param reach the most that coordinates differ by. */
PointSet findCorners(const Points& points, int reach)
{
    PointSet corners;
    // The normals of edges have components up to `reach`, and directions between those of two edges up to twice that.
    for (int x = -2 * reach; x <= 2 * reach; ++x)
        for (int y = -2 * reach; y <= 2 * reach; ++y)
        {
            const auto distanceOf = [&](const Eigen::Vector2d& point) { return x * point.x() + y * point.y(); };
            const auto farthest = std::max_element(points.begin(), points.end(),
                                                   [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
                                                   { return distanceOf(a) < distanceOf(b); });
            const bool isAlone = std::all_of(points.begin(), points.end(),
                                             [&](const Eigen::Vector2d& point) {
                                                 return point == *farthest || distanceOf(point) < distanceOf(*farthest);
                                             });
            if (isAlone && !corners.contains({farthest->x(), farthest->y()}))
                corners.emplace(farthest->x(), farthest->y());
        }
    return corners;
}

TEST(ContactPoints, TheHullHasTheOutermostPointsCounterclockwise)
{
    constexpr int REACH = 5;
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round)
    {
        Points points;
        const std::size_t count = 3 + random() % 12;
        for (std::size_t i = 0; i < count; ++i)
            points.emplace_back(static_cast<double>(random() % (REACH + 1)),
                                static_cast<double>(random() % (REACH + 1)));
        const Points hull = findHull(points);
        const PointSet corners = findCorners(points, REACH);
        if (corners.size() < 2) continue; // the same point several times
        EXPECT_EQ(toSet(hull), corners) << round;
        for (std::size_t i = 0; hull.size() > 2 && i < hull.size(); ++i)
            EXPECT_GT(turnOf(hull[i], hull[(i + 1) % hull.size()], hull[(i + 2) % hull.size()]), 0.0) << round;
    }
}

} // namespace

} // namespace osgLego::test
