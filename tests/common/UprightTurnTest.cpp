#include <common/UprightTurn.h>

#include <gtest/gtest.h>
#include <osg/Group>

namespace osgLego
{

namespace
{

TEST(UprightTurn, TurnsYUpwardsAndKeepsX)
{
    const osg::ref_ptr<osg::MatrixTransform> turn = turnUpright(*osg::ref_ptr<osg::Group>(new osg::Group));
    EXPECT_EQ(osg::Vec3d(0, 1, 0) * turn->getMatrix(), osg::Vec3d(0, 0, 1));
    EXPECT_EQ(osg::Vec3d(1, 0, 0) * turn->getMatrix(), osg::Vec3d(1, 0, 0));
    EXPECT_EQ(osg::Vec3d(0, 0, 1) * turn->getMatrix(), osg::Vec3d(0, -1, 0));
}

TEST(UprightTurn, IsToldFromOtherNodes)
{
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    const osg::ref_ptr<osg::MatrixTransform> turn = turnUpright(*group);
    EXPECT_TRUE(isUprightTurn(*turn));
    EXPECT_FALSE(isUprightTurn(*group));
    const osg::ref_ptr<osg::MatrixTransform> other = new osg::MatrixTransform(osg::Matrixd::rotate(1.0, 1, 0, 0));
    other->addChild(group);
    EXPECT_FALSE(isUprightTurn(*other));
}

} // namespace

} // namespace osgLego
