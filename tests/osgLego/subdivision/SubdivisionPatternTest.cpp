#include <osgLego/flattening/SubdivisionPattern.h>
#include <osgLego/subdivision/GridCut.h>

#include <FineTriangles.h>
#include <Meshes.h>
#include <Settings.h>

#include <algorithm>
#include <tuple>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(SubdivisionPattern, PreservesAreasAndNormals)
{
    for (const double limit : {0.5, 1.0, 2.0})
    {
        const GridVertices source = createTetrahedra(1, 60, true);
        const GridVertices fine = subdivideOnCpu(source, limit).vertices;
        expectSameAreas(source, fine);
        expectSameNormals(source, fine);
    }
}

TEST(SubdivisionPattern, LeavesNoCracksBetweenNeighbours)
{
    for (const double limit : {0.5, 1.0, 2.0})
    {
        const GridVertices source = createTetrahedra(2, 60, true);
        expectNoCracks(source);
        expectNoCracks(subdivideOnCpu(source, limit).vertices);
    }
}

TEST(SubdivisionPattern, LeavesNoLongEdgeAfterTheExpectedNumberOfPasses)
{
    for (const double limit : {0.5, 1.0, 2.0})
    {
        const GridVertices source = createTetrahedra(3, 60, true);
        expectShortEdges(subdivideOnCpu(source, limit).vertices, limit);
        for (std::size_t first = 0; first < source.size(); first += 3)
        {
            GridVertices triangle(source.begin() + static_cast<std::ptrdiff_t>(first),
                                  source.begin() + static_cast<std::ptrdiff_t>(first + 3));
            ASSERT_LE(subdivideOnCpu(triangle, limit).numPasses, mostPasses(triangle, limit)) << first;
        }
    }
}

TEST(SubdivisionPattern, InterpolatesTextureCoordinatesAndColours)
{
    expectLinearAttributes(subdivideOnCpu(createTetrahedra(4, 60, true), 1.0).vertices, 5e-4);
}

TEST(SubdivisionPattern, CutsOneTwoOrThreeEdgesAsThePaperDoes)
{
    const auto count = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
    {
        GridVertex vertices[3];
        vertices[0].position = a;
        vertices[1].position = b;
        vertices[2].position = c;
        int parts = 0;
        cutLongEdges(std::array<GridVertex, 3>{vertices[0], vertices[1], vertices[2]}, 1.0f,
                     [&](const std::array<GridVertex, 3>&) { ++parts; });
        return parts;
    };
    EXPECT_EQ(count({0, 0, 0}, {1, 0, 0}, {0.5f, 0.5f, 0}), 1) << "an edge of exactly the limit is not cut";
    EXPECT_EQ(count({0, 0, 0}, {1.5f, 0, 0}, {0.75f, 0.1f, 0}), 2);
    EXPECT_EQ(count({0, 0, 0}, {1.5f, 0, 0}, {1.5f, 0.1f, 0}), 3);
    EXPECT_EQ(count({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), 4);
}

TEST(SubdivisionPattern, CutsAQuadrilateralAlongItsShorterDiagonal)
{
    const auto longestInside = [](const glm::vec3& c)
    {
        GridVertex a;
        GridVertex b;
        b.position = {2.0f, 0.0f, 0.0f};
        GridVertex last;
        last.position = c;
        float longest = 0.0f;
        cutLongEdges(std::array<GridVertex, 3>{a, b, last}, 1.0f,
                     [&](const std::array<GridVertex, 3>& part)
                     {
                         for (std::size_t edge = 0; edge < 3; ++edge)
                             longest = std::max(longest, squaredLength(part[edge], part[(edge + 1) % 3]));
                     });
        return longest;
    };
    // The squares of the other diagonals are 2.11 and 3.65.
    EXPECT_LE(longestInside({0.9f, 0.2f, 0.0f}), 1.01f);
    EXPECT_LE(longestInside({-0.9f, 0.2f, 0.0f}), 2.12f);
}

/** Whether the bounds of a triangle reach into a grid. */
bool reaches(const GridVertex* corners, const GridTriangles& triangles)
{
    const glm::vec3 begin(triangles.getFirstCell());
    const glm::vec3 end = begin + glm::vec3(triangles.getGrid().dimensions);
    const glm::vec3 lowest = glm::min(corners[0].position, glm::min(corners[1].position, corners[2].position));
    const glm::vec3 highest = glm::max(corners[0].position, glm::max(corners[1].position, corners[2].position));
    return glm::all(glm::greaterThanEqual(highest, begin)) && glm::all(glm::lessThan(lowest, end));
}

using Key = std::array<float, 9>;

/** The fine triangles that reach into a grid, in an order that does not depend on the passes. */
std::vector<Key> fineInside(const GridVertices& coarse, const GridTriangles& triangles, double edgeLimit)
{
    const GridVertices fine = subdivideOnCpu(coarse, edgeLimit).vertices;
    std::vector<Key> keys;
    for (std::size_t first = 0; first < fine.size(); first += 3)
    {
        if (!reaches(&fine[first], triangles)) continue;
        Key key;
        for (std::size_t component = 0; component < 9; ++component)
            key[component] = fine[first + component / 3].position[static_cast<int>(component % 3)];
        keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

osg::ref_ptr<const GridTriangles> createPart(osg::Node& node, const std::string& text)
{
    return GridTriangles::create(*SceneTriangles::create(node), parseSettings(text));
}

TEST(GridCut, LeavesTheFineTrianglesInTheGrid)
{
    osg::ref_ptr<osg::Group> node = new osg::Group;
    node->addChild(createSliverSoup(100));
    node->addChild(createTriangle({-7, -6, 0.2f}, {8, -7, -0.3f}, {0.5f, 7, 0.1f}));
    for (const double limit : {1.0, 2.0})
    {
        const osg::ref_ptr<const GridTriangles> triangles =
            createPart(*node, "cell=0.04,origin=-0.2:-0.3:-0.1,size=22:17:13");
        const GridBatch& batch = triangles->getBatches().front();
        const std::optional<GridBatch> parts = cutToGrid(batch, *triangles, limit);
        ASSERT_TRUE(parts);
        const std::vector<Key> expected = fineInside(batch.vertices, *triangles, limit);
        EXPECT_GT(expected.size(), 300u);
        EXPECT_EQ(fineInside(parts->vertices, *triangles, limit), expected);
        EXPECT_LT(parts->longestEdge, 60.0f) << "parts end near the grid";
    }
}

TEST(GridCut, KeepsTrianglesThatEndNearTheGrid)
{
    const osg::ref_ptr<osg::Node> sphere = createSphere();
    const osg::ref_ptr<const GridTriangles> near = createPart(*sphere, "cell=0.1,origin=-0.5:-0.9:-0.9,size=10:18:18");
    EXPECT_FALSE(cutToGrid(near->getBatches().front(), *near, 1.0));
    const osg::ref_ptr<const GridTriangles> fitted = createPart(*sphere, "20");
    EXPECT_FALSE(cutToGrid(fitted->getBatches().front(), *fitted, 1.0));
}

} // namespace

} // namespace osgLego::test
