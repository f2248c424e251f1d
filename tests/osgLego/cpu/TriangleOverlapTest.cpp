#include <osgLego/cpu/TriangleOverlap.h>

#include <CellClipping.h>

#include <algorithm>
#include <random>
#include <vector>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using test::clipByCell;
using test::Polygon;

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
            for (int number = 0; number < 1000; ++number)
            {
                const glm::ivec3 cell(number % 10, number / 10 % 10, number / 100);
                const Polygon part = clipByCell(triangle, cell);
                if (std::abs(overlap.getMargin(cell)) > 1e-9)
                {
                    ASSERT_EQ(overlap.overlaps(cell), !part.empty());
                    ASSERT_EQ(overlap.getMargin(cell) > 0.0, !part.empty());
                }
            }
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
    // The plane x + y = 4 contains edges of the grid. It doesn't cover cells that it touches only along an edge.
    const TriangleOverlap overlap({4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, {0.0, 4.0, 4.0});
    std::vector<glm::ivec3> cells;
    overlap.findCells(glm::ivec3(10), cells);
    EXPECT_FALSE(cells.empty());
    for (const glm::ivec3& cell : cells)
    {
        const int sum = cell.x + cell.y;
        EXPECT_TRUE(sum == 3 || sum == 4) << cell.x << " " << cell.y;
        // The edge that the plane touches is the lower edge of cells with sum 4, but not of cells with sum 2.
    }
}

} // namespace

} // namespace osgLego
