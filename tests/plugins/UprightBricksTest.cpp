#include <osgLego/BrickIntersection.h>
#include <osgLego/LegoNode.h>

#include <TemporaryFolder.h>

#include <optional>

#include <osg/Geode>
#include <osg/ShapeDrawable>
#include <osg/Transform>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

namespace osgLego::test
{

namespace
{

/** A mesh that is 4 high along y, 2 along x and 1 along z, from the origin on. */
osg::ref_ptr<osg::Node> createTallBox()
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(new osg::ShapeDrawable(new osg::Box(osg::Vec3(1.0f, 2.0f, 0.5f), 2.0f, 4.0f, 1.0f)));
    return geode;
}

osg::ref_ptr<LegoNode> findLego(osg::Node& node)
{
    if (auto* lego = dynamic_cast<LegoNode*>(&node)) return lego;
    osg::Group* group = node.asGroup();
    return group && group->getNumChildren() == 1 ? findLego(*group->getChild(0)) : nullptr;
}

osg::Matrixd computeToWorld(const osg::Node& node)
{
    return osg::computeLocalToWorld(node.getParentalNodePaths().front());
}

/** Bricks that the pseudo-loader makes with `up=y`. */
class UprightBricks : public TemporaryFolderTest
{
protected:
    void SetUp() override
    {
        TemporaryFolderTest::SetUp();
        ASSERT_TRUE(osgDB::writeNodeFile(*createTallBox(), pathOf("box.osgt")));
    }

    osg::ref_ptr<osg::Node> read(const std::string& name) const
    {
        osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(pathOf(name));
        EXPECT_TRUE(node) << name;
        return node;
    }
};

TEST_F(UprightBricks, StandInTheWorldAndKeepTheCoordinatesOfTheMesh)
{
    for (const char* look : {"full", "plain"})
    {
        const osg::ref_ptr<osg::Node> scene = read("box.osgt.(cell=1,up=y,look=" + std::string(look) + ").legolize");
        ASSERT_TRUE(scene);
        const osg::ref_ptr<LegoNode> lego = findLego(*scene);
        ASSERT_TRUE(lego);
        // The node keeps the coordinates of the mesh.
        EXPECT_EQ(lego->getBricks()->getGrid().dimensions, glm::ivec3(3, 5, 2));
        const osg::Matrixd toWorld = computeToWorld(*lego);
        EXPECT_EQ(osg::Vec3d(1, 4, 0.5) * toWorld, osg::Vec3d(1, -0.5, 4));
    }
    EXPECT_TRUE(dynamic_cast<LegoNode*>(read("box.osgt.(cell=1,look=plain).legolize").get()));
}

TEST_F(UprightBricks, ArePickedFromAbove)
{
    const osg::ref_ptr<osg::Node> scene = read("box.osgt.(cell=1,up=y,look=plain).legolize");
    ASSERT_TRUE(scene);
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> line =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(0.5, -0.5, 20), osg::Vec3d(0.5, -0.5, -20));
    osgUtil::IntersectionVisitor visitor(line);
    scene->accept(visitor);
    ASSERT_TRUE(line->containsIntersections());
    const osgUtil::LineSegmentIntersector::Intersection hit = line->getFirstIntersection();
    // The highest cell is that from 4 to 5 along the mesh's y, and has a stud above.
    const std::optional<BrickIntersection> brick = BrickIntersection::find(hit);
    ASSERT_TRUE(brick);
    EXPECT_EQ(brick->brick.getCell(), glm::ivec3(0, 4, 0));
    EXPECT_TRUE(brick->isStud);
    EXPECT_GT(hit.getWorldIntersectPoint().z(), 5.0);
}

TEST_F(UprightBricks, StayUprightInFilesOfStoredBricks)
{
    const osg::ref_ptr<osg::Node> scene = read("box.osgt.(cell=1,up=y).legolize");
    ASSERT_TRUE(
        osgDB::writeNodeFile(*scene, pathOf("baked.osgb"), osg::ref_ptr<osgDB::Options>(new osgDB::Options("bake"))));
    for (const char* name : {"baked.osgb", "baked.osgb.(occlusion=low).legolize"})
    {
        const osg::ref_ptr<osg::Node> back = read(name);
        ASSERT_TRUE(back) << name;
        const osg::BoundingSphere before = scene->getBound();
        EXPECT_NEAR((back->getBound().center() - before.center()).length(), 0.0, 1e-5) << name;
        ASSERT_TRUE(findLego(*back)) << name;
        const osg::Matrixd toWorld = computeToWorld(*findLego(*back));
        EXPECT_EQ(osg::Vec3d(1, 4, 0.5) * toWorld, osg::Vec3d(1, -0.5, 4)) << name;
    }
}

} // namespace

} // namespace osgLego::test
