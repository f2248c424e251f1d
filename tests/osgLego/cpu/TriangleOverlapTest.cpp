#include <osgLego/cpu/TriangleOverlap.h>

#include <algorithm>
#include <random>
#include <vector>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using Polygon = std::vector<glm::dvec3>;

/** Another way to the same: clip the triangle by the cell's six planes, one after the other. */
Polygon clippedByCell(const Polygon& triangle, const glm::ivec3& cell)
{
    Polygon polygon = triangle;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
        {
            const double bound = sign > 0.0 ? cell[axis] : cell[axis] + 1.0;
            Polygon result;
            for (std::size_t index = 0; index < polygon.size(); ++index)
            {
                const glm::dvec3& from = polygon[index];
                const glm::dvec3& to = polygon[(index + 1) % polygon.size()];
                const double here = sign * (from[axis] - bound);
                const double there = sign * (to[axis] - bound);
                if (here >= 0.0) result.push_back(from);
                if ((here >= 0.0) != (there >= 0.0)) result.push_back(glm::mix(from, to, here / (here - there)));
            }
            polygon = result;
        }
    return polygon;
}

double areaOf(const Polygon& polygon)
{
    glm::dvec3 sum(0.0);
    for (std::size_t index = 2; index < polygon.size(); ++index)
        sum += glm::cross(polygon[index - 1] - polygon[0], polygon[index] - polygon[0]);
    return 0.5 * glm::length(sum);
}

class RandomTriangles
{
public:
    explicit RandomTriangles(double reach) : _place(0.5, 9.5), _step(-reach, reach) {}

    Polygon next()
    {
        const glm::dvec3 a(_place(_engine), _place(_engine), _place(_engine));
        return {a, clamped(a), clamped(a)};
    }

private:
    glm::dvec3 clamped(const glm::dvec3& from)
    {
        return glm::clamp(from + glm::dvec3(_step(_engine), _step(_engine), _step(_engine)), 0.0, 10.0);
    }

    std::mt19937 _engine{42};
    std::uniform_real_distribution<double> _place;
    std::uniform_real_distribution<double> _step;
};

TEST(TriangleOverlap, AgreesWithClippingOnRandomTriangles)
{
    for (const double reach : {0.3, 1.0, 3.0, 10.0})
    {
        RandomTriangles triangles(reach);
        for (int repeat = 0; repeat < 300; ++repeat)
        {
            const Polygon triangle = triangles.next();
            const TriangleOverlap overlap(triangle[0], triangle[1], triangle[2]);
            double area = 0.0;
            for (int number = 0; number < 1000; ++number)
            {
                const glm::ivec3 cell(number % 10, number / 10 % 10, number / 100);
                const Polygon part = clippedByCell(triangle, cell);
                if (std::abs(overlap.getMargin(cell)) > 1e-9)
                {
                    ASSERT_EQ(overlap.overlaps(cell), !part.empty());
                    ASSERT_EQ(overlap.getMargin(cell) > 0.0, !part.empty());
                }
                if (!overlap.overlaps(cell)) continue;
                ASSERT_NEAR(overlap.getAreaInside(cell), areaOf(part), 1e-9);
                area += overlap.getAreaInside(cell);
            }
            ASSERT_NEAR(area, areaOf(triangle), 1e-8) << "the parts do not make up the whole";
        }
    }
}

TEST(TriangleOverlap, FindsEveryOverlappedCellOnce)
{
    for (const double reach : {0.5, 4.0, 10.0})
    {
        RandomTriangles triangles(reach);
        for (int repeat = 0; repeat < 200; ++repeat)
        {
            const Polygon triangle = triangles.next();
            const TriangleOverlap overlap(triangle[0], triangle[1], triangle[2]);
            std::vector<glm::ivec3> found;
            overlap.findCells(glm::ivec3(10), found);
            std::size_t expected = 0;
            for (int number = 0; number < 1000; ++number)
            {
                const glm::ivec3 cell(number % 10, number / 10 % 10, number / 100);
                const auto times = std::count(found.begin(), found.end(), cell);
                ASSERT_EQ(times, overlap.overlaps(cell) ? 1 : 0);
                expected += overlap.overlaps(cell) ? 1u : 0u;
            }
            ASSERT_EQ(found.size(), expected);
        }
    }
}

TEST(TriangleOverlap, ASurfaceOnABoundaryFillsOneSideOfIt)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        glm::dvec3 a(0.0);
        glm::dvec3 b(0.0);
        glm::dvec3 c(0.0);
        a[axis] = b[axis] = c[axis] = 3.0;
        b[(axis + 1) % 3] = 5.0;
        c[(axis + 2) % 3] = 5.0;
        const TriangleOverlap overlap(a, b, c);
        std::vector<glm::ivec3> cells;
        overlap.findCells(glm::ivec3(10), cells);
        EXPECT_FALSE(cells.empty());
        for (const glm::ivec3& cell : cells)
            EXPECT_EQ(cell[axis], 3);
    }
}

TEST(TriangleOverlap, ADiagonalSurfaceThroughEdgesFillsOneSideOfThem)
{
    // The plane x + y = 4 runs through edges of the grid: of the cells that it only touches there, none counts.
    const TriangleOverlap overlap({4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, {0.0, 4.0, 4.0});
    std::vector<glm::ivec3> cells;
    overlap.findCells(glm::ivec3(10), cells);
    EXPECT_FALSE(cells.empty());
    for (const glm::ivec3& cell : cells)
    {
        const int sum = cell.x + cell.y;
        EXPECT_TRUE(sum == 3 || sum == 4) << cell.x << " " << cell.y;
        // Cells with sum 4 hold the edge that the plane touches as their own lower corner; those with sum 2 do not.
    }
}

TEST(TriangleOverlap, NearestPointIsNoFartherThanAnyOther)
{
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    for (int repeat = 0; repeat < 2000; ++repeat)
    {
        const auto random = [&] { return glm::dvec3(place(engine), place(engine), place(engine)); };
        const glm::dvec3 a = random();
        const glm::dvec3 b = random();
        const glm::dvec3 c = random();
        const glm::dvec3 point = random();
        const glm::dvec3 weights = TriangleOverlap(a, b, c).findNearest(point);
        ASSERT_NEAR(weights.x + weights.y + weights.z, 1.0, 1e-9);
        ASSERT_GE(std::min({weights.x, weights.y, weights.z}), -1e-9);
        const double distance = glm::distance(point, weights.x * a + weights.y * b + weights.z * c);
        for (int u = 0; u <= 10; ++u)
            for (int v = 0; u + v <= 10; ++v)
                ASSERT_LE(distance,
                          glm::distance(point, (a * double(u) + b * double(v) + c * double(10 - u - v)) / 10.0) + 1e-9);
    }
}

} // namespace

} // namespace osgLego
