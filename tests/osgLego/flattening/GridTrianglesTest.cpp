#include <osgLego/flattening/GridTriangles.h>

#include <Meshes.h>
#include <Settings.h>

#include <set>

#include <gtest/gtest.h>
#include <osg/Group>
#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

osg::ref_ptr<const GridTriangles> createTriangles(osg::Node& node, const std::string& text)
{
    return GridTriangles::create(*SceneTriangles::create(node), parseSettings(text));
}

std::set<std::array<float, 3>> placesOf(const GridTriangles& triangles)
{
    std::set<std::array<float, 3>> places;
    for (const GridBatch& batch : triangles.getBatches())
        for (const GridVertex& vertex : batch.vertices)
            places.insert({vertex.position.x, vertex.position.y, vertex.position.z});
    return places;
}

TEST(GridTriangles, PositionsAreTheSameInEveryGridOfALattice)
{
    const osg::ref_ptr<osg::Node> sphere = createSphere();
    const osg::ref_ptr<const GridTriangles> whole =
        createTriangles(*sphere, "cell=0.0625,origin=-2:-2:-2,size=64:64:64");
    const osg::ref_ptr<const GridTriangles> part =
        createTriangles(*sphere, "cell=0.0625,origin=-0.5:0.25:-1,size=20:10:30");
    const std::set<std::array<float, 3>> expected = placesOf(*whole);
    const std::set<std::array<float, 3>> places = placesOf(*part);
    EXPECT_GT(places.size(), 100u);
    EXPECT_LT(places.size(), expected.size() / 2);
    for (const std::array<float, 3>& place : places)
        ASSERT_TRUE(expected.contains(place)) << place[0] << ' ' << place[1] << ' ' << place[2];
    EXPECT_EQ(part->getFirstCell() - whole->getFirstCell(), glm::ivec3(24, 36, 16));
}

TEST(GridTriangles, EqualOnesAreShared)
{
    const osg::ref_ptr<const GridTriangles> first = GridTriangles::share(*createTriangles(*createSphere(), "16"));
    EXPECT_EQ(GridTriangles::share(*createTriangles(*createSphere(), "16")), first);
    const osg::ref_ptr<const GridTriangles> finer = createTriangles(*createSphere(), "17");
    EXPECT_EQ(GridTriangles::share(*finer), finer);
}

TEST(GridTriangles, ThoseAtAnotherPlaceAreNotShared)
{
    const osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform(osg::Matrix::translate(1, 2, 3));
    moved->addChild(createSphere());
    const osg::ref_ptr<const GridTriangles> here = createTriangles(*createSphere(), "16");
    const osg::ref_ptr<const GridTriangles> there = createTriangles(*moved, "16");
    EXPECT_EQ(GridTriangles::share(*here), here);
    EXPECT_EQ(GridTriangles::share(*there), there);
}

TEST(GridTriangles, AFittedGridContainsAllPositions)
{
    const osg::ref_ptr<const GridTriangles> triangles = createTriangles(*createSphere(), "16");
    EXPECT_EQ(triangles->getFirstCell(), glm::ivec3(0));
    EXPECT_EQ(triangles->getNumTriangles(), SceneTriangles::create(*createSphere())->getNumTriangles());
    for (const std::array<float, 3>& place : placesOf(*triangles))
        for (const float coordinate : place)
            ASSERT_TRUE(coordinate >= 0.0f && coordinate < 16.0f) << coordinate;
}

TEST(GridTriangles, TrianglesBesideTheGridAreOmitted)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createTriangle({0.2f, 0.3f, 0.1f}, {0.8f, 0.3f, 0.1f}, {0.2f, 0.9f, 0.4f}));
    group->addChild(createTriangle({5, 0, 0}, {6, 0, 0}, {5, 1, 0}));
    group->addChild(createTriangle({-40, -30, -20}, {-6, 0, 0}, {-5, 1, 0}));
    EXPECT_EQ(createTriangles(*group, "cell=0.1,origin=0:0:0,size=10:10:10")->getNumTriangles(), 1u);
    EXPECT_EQ(createTriangles(*group, "cell=0.1,origin=2:2:2,size=9:9:9")->getNumTriangles(), 0u);
    EXPECT_EQ(createTriangles(*group, "cell=0.5")->getNumTriangles(), 3u);
}

TEST(GridTriangles, ALongSliverHasFewPartsNearTheGrid)
{
    // Three long edges: the middle corner is near the line between the others.
    for (const float length : {1e5f, 1e9f, 1e15f})
    {
        const osg::ref_ptr<osg::Geometry> sliver =
            createTriangle({-length, 0, 0}, {0, 1e-9f, 0}, {0.1f * length, 0, 0});
        const osg::ref_ptr<const GridTriangles> triangles =
            createTriangles(*sliver, "cell=0.25,origin=-1:-1:-1,size=8:8:8");
        EXPECT_GT(triangles->getNumTriangles(), 0u);
        EXPECT_LE(triangles->getNumTriangles(), 100u) << length;
        EXPECT_LE(triangles->getLongestEdge(), 1.8f * 8192.0f);
    }
}

TEST(GridTriangles, TheEstimateOfCoveredCellsCountsNothingBesideTheGrid)
{
    const osg::ref_ptr<osg::Node> floor = createTriangle({-900, -900, 0.5f}, {900, -900, 0.5f}, {0, 900, 0.5f});
    const osg::ref_ptr<const GridTriangles> triangles =
        createTriangles(*floor, "cell=1,origin=-20:-20:-20,size=40:40:40");
    EXPECT_GE(triangles->estimateCoveredCells(), 1600u);
    EXPECT_LE(triangles->estimateCoveredCells(), 1800u);
}

} // namespace

} // namespace osgLego::test
