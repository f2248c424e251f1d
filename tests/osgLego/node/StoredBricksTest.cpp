#include <common/RacingCar.h>
#include <osgLego/BrickIntersection.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/LegoNode.h>

#include <Meshes.h>

#include <gtest/gtest.h>
#include <osg/Geode>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

namespace osgLego::test
{

namespace
{

/** The bricks of a car, stored in a node without children. */
class StoredBricksTest : public ::testing::Test
{
protected:
    void SetUp() override
    {
        _settings.grid.resolution = 20;
        _bricks = legolizeOnCpu(*createRacingCar(), _settings);
        _lego->setStoredBricks(_bricks);
    }

    LegoSettings _settings;
    osg::ref_ptr<const BrickModel> _bricks;
    osg::ref_ptr<LegoNode> _lego = new LegoNode;
};

TEST_F(StoredBricksTest, TheNodeHasTheseBricksAndTheirBounds)
{
    EXPECT_EQ(_lego->getStoredBricks(), _bricks);
    EXPECT_EQ(_lego->getBricks(), _bricks);
    EXPECT_TRUE(_lego->hasTriangles());
    const osg::BoundingBoxd bounds = _bricks->getGrid().getBrickBounds();
    EXPECT_NEAR(_lego->getBound().radius(), bounds.radius(), 1e-5);
    EXPECT_NEAR((osg::Vec3d(_lego->getBound().center()) - bounds.center()).length(), 0.0, 1e-5);
}

TEST_F(StoredBricksTest, ChildrenAddedLaterAndSettingsDoNotChangeThem)
{
    _lego->addChild(createSphere(4));
    _settings.grid.resolution = 5;
    _lego->setSettings(_settings);
    _lego->dirty();
    EXPECT_EQ(_lego->getBricks(), _bricks);
    EXPECT_NEAR(_lego->getBound().radius(), _bricks->getGrid().getBrickBounds().radius(), 1e-5);
}

TEST_F(StoredBricksTest, TheyNeedNoPalette)
{
    _settings.colors.palette = "no-such-palette.csv";
    _settings.view.look = Look::PLAIN;
    EXPECT_TRUE(_lego->setSettings(_settings));
    EXPECT_EQ(_lego->getSettings().view.look, Look::PLAIN);
    EXPECT_EQ(_lego->getBricks(), _bricks);

    const osg::ref_ptr<LegoNode> live = new LegoNode;
    live->addChild(createSphere(4));
    EXPECT_FALSE(live->setSettings(_settings));
}

TEST_F(StoredBricksTest, WithoutThemTheChildrenAreLegolizedAgain)
{
    _lego->setSettings(_settings);
    _lego->addChild(createSphere(8));
    _lego->setStoredBricks(nullptr);
    const osg::ref_ptr<const BrickModel> expected = legolizeOnCpu(*createSphere(8), _settings);
    ASSERT_TRUE(_lego->getBricks());
    EXPECT_TRUE(_lego->getBricks()->getBricks() == expected->getBricks());

    _lego->removeChildren(0, 1);
    EXPECT_FALSE(_lego->hasTriangles());
    EXPECT_FALSE(_lego->getBricks());
}

TEST_F(StoredBricksTest, TheyReplaceTheBricksOfTheChildren)
{
    const osg::ref_ptr<LegoNode> lego = new LegoNode(_settings);
    lego->addChild(createSphere(8));
    EXPECT_NE(lego->getBricks(), _bricks);
    lego->getBound();
    lego->setStoredBricks(_bricks);
    EXPECT_EQ(lego->getBricks(), _bricks);
    EXPECT_NEAR(lego->getBound().radius(), _bricks->getGrid().getBrickBounds().radius(), 1e-5);
}

TEST_F(StoredBricksTest, CopiesShareThemEvenIfTheOriginalChanges)
{
    for (const auto flags : {osg::CopyOp::SHALLOW_COPY, osg::CopyOp::DEEP_COPY_ALL})
    {
        _lego->setStoredBricks(_bricks);
        const osg::ref_ptr<LegoNode> copy = osg::clone(_lego.get(), osg::CopyOp(flags));
        EXPECT_EQ(copy->getStoredBricks(), _bricks);
        _lego->setStoredBricks(nullptr);
        EXPECT_EQ(copy->getBricks(), _bricks);
        EXPECT_NEAR(copy->getBound().radius(), _bricks->getGrid().getBrickBounds().radius(), 1e-5);
    }
}

TEST_F(StoredBricksTest, TheyCanBePicked)
{
    const osg::Vec3d center = _bricks->getGrid().getBrickBounds().center();
    const osg::Vec3d above(0, 0, 2.0 * _bricks->getGrid().getBrickBounds().radius());
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
        new osgUtil::LineSegmentIntersector(center + above, center - above);
    osgUtil::IntersectionVisitor visitor(ray);
    _lego->accept(visitor);
    ASSERT_TRUE(ray->containsIntersections());
    const std::optional<BrickIntersection> found = BrickIntersection::find(ray->getFirstIntersection());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->node, _lego);
    EXPECT_EQ(found->model, _bricks);
    // The highest brick below the ray.
    const glm::ivec3 cell = found->brick.getCell();
    EXPECT_TRUE(_bricks->find(cell));
    for (int z = cell.z + 1; z < _bricks->getGrid().dimensions.z; ++z)
        EXPECT_FALSE(_bricks->find({cell.x, cell.y, z}));
}

TEST_F(StoredBricksTest, TheyCanBeAPartOfAnotherSource)
{
    const osg::ref_ptr<LegoNode> outer = new LegoNode(_settings);
    outer->addChild(_lego);
    ASSERT_TRUE(outer->getBricks());
    EXPECT_GT(outer->getBricks()->getBricks().size(), 100u);
    const osg::ref_ptr<const BrickModel> before = outer->getBricks();
    const osg::ref_ptr<osg::Node> ball = createSphere(8);
    _lego->setStoredBricks(legolizeOnCpu(*ball, _settings).get());
    outer->dirty();
    EXPECT_FALSE(outer->getBricks()->getBricks() == before->getBricks());
}

TEST_F(StoredBricksTest, AnEmptyModelShowsNothing)
{
    const osg::ref_ptr<const BrickModel> empty = BrickModel::create(BrickGrid(), {});
    _lego->setStoredBricks(empty);
    EXPECT_EQ(_lego->getBricks(), empty);
    EXPECT_FALSE(_lego->getBound().valid());
}

} // namespace

} // namespace osgLego::test
