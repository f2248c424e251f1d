#include <osgLego/cpu/TriangleOverlap.h>
#include <osgLego/cpu/TriangleSlicer.h>

#include <CellClipping.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using test::areaOf;
using Corners = std::array<glm::vec3, 3>;

constexpr int SIZE = 1024;

/** Creates triangles inside a grid of SIZE cells. */
class Triangles
{
public:
    float between(float lowest, float highest)
    {
        return std::uniform_real_distribution<float>(lowest, highest)(_generator);
    }

    glm::vec3 place(float lowest, float highest)
    {
        return {between(lowest, highest), between(lowest, highest), between(lowest, highest)};
    }

    Corners anywhere(float size)
    {
        const glm::vec3 first = place(0.0f, SIZE - 1.0f);
        return {first, inside(first + place(-size, size)), inside(first + place(-size, size))};
    }

    /** Corners at multiples of a fraction of a cell, where cuts and corners meet the planes between cells. */
    Corners onLattice(float size, float fraction)
    {
        Corners corners = anywhere(size);
        for (glm::vec3& corner : corners)
            corner = glm::round(corner / fraction) * fraction;
        return corners;
    }

private:
    static glm::vec3 inside(const glm::vec3& place)
    {
        return glm::clamp(place, glm::vec3(0.0f), glm::vec3(std::nextafter(static_cast<float>(SIZE), 0.0f)));
    }

    std::mt19937 _generator{17};
};

bool isBefore(const CellPart& a, const CellPart& b)
{
    return std::tie(a.cell.z, a.cell.y, a.cell.x) < std::tie(b.cell.z, b.cell.y, b.cell.x);
}

/** Slices a triangle. If the slicer decides, its parts must equal those of TriangleOverlap; otherwise all of the
 * triangle's area, except a millionth of a cell, must lie in cells that TriangleOverlap finds. @return whether the
 * slicer decided. */
bool agrees(const Corners& corners, const glm::ivec3& minimum = glm::ivec3(0),
            const glm::ivec3& maximum = glm::ivec3(SIZE - 1))
{
    std::vector<CellPart> parts{CellPart{}};
    const bool isDecided = TriangleSlicer(corners[0], corners[1], corners[2]).slice(minimum, maximum, parts);
    parts.erase(parts.begin());
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end(), isBefore));

    const TriangleOverlap overlap(corners[0], corners[1], corners[2]);
    const test::Polygon triangle(corners.begin(), corners.end());
    double area = 0.0;
    for (const CellPart& part : parts)
    {
        EXPECT_GE(part.area, -1e-12);
        EXPECT_TRUE(overlap.overlaps(part.cell) || (!isDecided && part.area < 1e-6));
        if (isDecided)
        {
            EXPECT_NEAR(part.area, areaOf(test::clipByCell(triangle, part.cell)), 1e-6);
        }
        area += part.area;
    }
    if (isDecided)
    {
        std::vector<glm::ivec3> cells;
        overlap.findCells(minimum, maximum, cells);
        EXPECT_EQ(parts.size(), cells.size());
    }
    if (minimum == glm::ivec3(0) && maximum == glm::ivec3(SIZE - 1))
    {
        EXPECT_NEAR(area, areaOf(triangle), 1e-6);
    }
    return isDecided;
}

TEST(TriangleSlicer, FindsTheCellsAndAreasThatTheOverlapTestFinds)
{
    Triangles triangles;
    for (const float size : {0.2f, 1.0f, 4.0f, 30.0f})
    {
        int decided = 0;
        for (int number = 0; number < 2000; ++number)
            decided += agrees(triangles.anywhere(size)) ? 1 : 0;
        EXPECT_GT(decided, 1900) << "triangles of " << size;
    }
}

TEST(TriangleSlicer, DecidesNothingWronglyOnTheLatticeOfTheCells)
{
    Triangles triangles;
    for (const float fraction : {1.0f, 0.5f, 0.25f, 0.1f})
        for (int number = 0; number < 2000; ++number)
            agrees(triangles.onLattice(4.0f, fraction));
}

TEST(TriangleSlicer, DecidesNothingWronglyNearTheLatticeOrNearlyParallelToIt)
{
    Triangles triangles;
    for (const float distance : {1e-3f, 1e-4f, 1e-5f, 1e-6f, 1e-7f})
    {
        int decided = 0;
        for (int number = 0; number < 4000; ++number)
        {
            Corners corners = triangles.onLattice(6.0f, 0.5f);
            for (glm::vec3& corner : corners)
                corner = glm::clamp(glm::mod(corner, 8.0f) + triangles.place(-distance, distance), glm::vec3(0.0f),
                                    glm::vec3(8.0f));
            decided += agrees(corners) ? 1 : 0;
        }
        EXPECT_GT(decided, 300) << "within " << distance;
    }
}

TEST(TriangleSlicer, DecidesExtrudedWallsWhoseCornersAreRounded)
{
    // Walls such as those of extruded letters: parallel to each of the axes, except for the last digits of a float.
    Triangles triangles;
    int decided = 0;
    for (int number = 0; number < 3000; ++number)
    {
        const int up = number % 3;
        Corners corners = triangles.anywhere(8.0f);
        corners[2] = corners[1] + triangles.place(-1e-5f, 1e-5f);
        corners[0][up] = 32.0f;
        corners[1][up] = 32.0f;
        corners[2][up] = 48.0f;
        decided += agrees(corners) ? 1 : 0;
    }
    EXPECT_GT(decided, 2500);
}

TEST(TriangleSlicer, DecidesNothingWronglyForSlivers)
{
    Triangles triangles;
    for (const float width : {1e-2f, 1e-4f, 1e-6f})
        for (int number = 0; number < 1000; ++number)
        {
            Corners corners = triangles.anywhere(20.0f);
            corners[2] = glm::clamp(glm::mix(corners[0], corners[1], 0.3f) + triangles.place(-width, width),
                                    glm::vec3(0.0f), glm::vec3(SIZE - 1.0f));
            agrees(corners);
        }
}

TEST(TriangleSlicer, IgnoresCellsOutsideTheBox)
{
    Triangles triangles;
    int decided = 0;
    for (int number = 0; number < 500; ++number)
    {
        const Corners corners = triangles.anywhere(20.0f);
        const glm::ivec3 first = glm::clamp(glm::ivec3(corners[0]) - 3, glm::ivec3(0), glm::ivec3(SIZE - 8));
        decided += agrees(corners, first, first + 7) ? 1 : 0;
    }
    EXPECT_GT(decided, 450);
}

TEST(TriangleSlicer, DecidesFacesAlongTheAxesWhereverTheyLie)
{
    // Vertical and horizontal faces, such as those of a box: on planes between cells, or with edges on them.
    Triangles triangles;
    int decided = 0;
    for (int number = 0; number < 1000; ++number)
    {
        Corners corners = triangles.onLattice(12.0f, 0.5f);
        const int axis = number % 3;
        corners[1][axis] = corners[0][axis];
        corners[2][axis] = corners[0][axis];
        const int other = (axis + 1) % 3;
        corners[1][other] = corners[0][other];
        decided += agrees(corners) ? 1 : 0;
    }
    EXPECT_GT(decided, 300);
}

TEST(TriangleSlicer, DecidesEveryTriangleInsideOneRowOfCells)
{
    Triangles triangles;
    for (int number = 0; number < 3000; ++number)
    {
        const int axis = number % 3;
        Corners corners = triangles.onLattice(6.0f, number % 2 == 0 ? 0.1f : 1e-4f);
        for (int across = 0; across < 3; ++across)
            if (across != axis)
                for (glm::vec3& corner : corners)
                    corner[across] = 7.0f + glm::fract(corner[across]);
        EXPECT_TRUE(agrees(corners));
        EXPECT_TRUE(agrees(corners, glm::ivec3(3), glm::ivec3(SIZE / 2)));
    }
}

TEST(TriangleSlicer, LeavesTrianglesWithoutAreaToTheOverlapTest)
{
    EXPECT_TRUE(agrees({glm::vec3(1.5f), glm::vec3(1.5f), glm::vec3(1.5f)}))
        << "the overlap test is not needed for a triangle in one cell";
    EXPECT_FALSE(agrees({glm::vec3(1.5f), glm::vec3(2.7f), glm::vec3(3.9f)}));
}

} // namespace

} // namespace osgLego
