#include <osgLego/BrickIntersection.h>

#include <BuildingOrders.h>
#include <PartModels.h>

#include <gtest/gtest.h>
#include <osgUtil/IntersectionVisitor>

namespace osgLego::test
{

namespace
{

/** A tower of parts of one cell each, the lowest first. */
osg::ref_ptr<const BrickModel> createTower(int height)
{
    std::vector<Part> parts(static_cast<std::size_t>(height));
    for (int level = 0; level < height; ++level)
        parts[static_cast<std::size_t>(level)].cell = {0, 0, static_cast<std::uint16_t>(level)};
    return BrickModel::createOfParts(createPartGrid({1, 1, height}), parts);
}

/** The first hit of a vertical ray that goes down through the middle of a cell. */
std::optional<BrickIntersection> pickFromAbove(osg::Node& scene)
{
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(0.5, 0.52, 100), osg::Vec3d(0.5, 0.52, -100));
    osgUtil::IntersectionVisitor visitor(ray);
    scene.accept(visitor);
    if (ray->getIntersections().empty()) return std::nullopt;
    return BrickIntersection::find(ray->getFirstIntersection());
}

TEST(PartialModel, OnlyPartsInPlaceArePicked)
{
    const osg::ref_ptr<const BrickModel> model = createTower(10);
    const osg::ref_ptr<LegoNode> node = createStoredNode(*model, "10");
    node->setWaiting(true);
    for (int numPlaced = 10; numPlaced > 0; --numPlaced)
    {
        node->setBuildProgress(numPlaced / 10.0);
        const std::optional<BrickIntersection> found = pickFromAbove(*node);
        ASSERT_TRUE(found) << numPlaced;
        EXPECT_EQ(found->part, &model->getParts()[static_cast<std::size_t>(numPlaced - 1)]);
        EXPECT_EQ(found->brick, model->getBricks()[static_cast<std::size_t>(numPlaced - 1)]);
        EXPECT_EQ(found->model, model);
        EXPECT_TRUE(found->isStud);
    }
    node->setBuildProgress(0.0);
    EXPECT_FALSE(pickFromAbove(*node));
}

TEST(PartialModel, TheOrderIsThatOfThePlanIfItFits)
{
    const osg::ref_ptr<const BrickModel> model = createTower(4);
    const osg::ref_ptr<LegoNode> node = createStoredNode(*model, "10,progress=0.25");
    node->setWaiting(true);
    const auto pickedLevel = [&] { return pickFromAbove(*node)->brick.cell[2]; };
    EXPECT_EQ(pickedLevel(), 0);
    const osg::ref_ptr<const BuildingPlan> plan = createPlan({2, 3, 0, 1});
    node->setBuildingPlan(plan);
    EXPECT_EQ(node->getBuildingPlan(), plan);
    EXPECT_EQ(pickedLevel(), 2);
    node->setBuildingPlan(createPlan({1, 0}).get());
    EXPECT_EQ(pickedLevel(), 0) << "the plan is for another number of parts";
    node->setBuildingPlan(plan);
    EXPECT_EQ(pickedLevel(), 2);
    node->setStoredBricks(createTower(8).get());
    EXPECT_EQ(pickedLevel(), 1) << "two of eight parts";
}

TEST(PartialModel, HasTheBoundsAndTheBricksOfAllParts)
{
    const osg::ref_ptr<const BrickModel> model = createTower(10);
    const osg::ref_ptr<LegoNode> node = createStoredNode(*model, "10");
    node->setWaiting(true);
    const osg::BoundingSphere bound = node->getBound();
    for (const double progress : {0.0, 0.5})
    {
        node->setBuildProgress(progress);
        pickFromAbove(*node);
        EXPECT_EQ(node->getBound(), bound);
        EXPECT_EQ(node->getBricks(), model);
    }
}

TEST(PartialModel, ProgressIsASettingFromZeroToOne)
{
    const osg::ref_ptr<LegoNode> node = createStoredNode(*createTower(3), "10");
    EXPECT_EQ(node->getBuildProgress(), 1.0);
    EXPECT_TRUE(node->setBuildProgress(0.25));
    EXPECT_EQ(node->getBuildProgress(), 0.25);
    EXPECT_EQ(node->getSettings().toString(), "10,progress=0.25");
    for (const double bad : {-0.01, 1.01, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_FALSE(node->setBuildProgress(bad));
    EXPECT_EQ(node->getBuildProgress(), 0.25);
    LegoSettings settings;
    settings.view.progress = 0.75;
    EXPECT_TRUE(node->setSettings(settings));
    EXPECT_EQ(node->getBuildProgress(), 0.75);
}

TEST(PartialModel, CopiesOfANodeShowTheSameParts)
{
    const osg::ref_ptr<LegoNode> node = createStoredNode(*createTower(3), "10,progress=0.5");
    node->setBuildingPlan(createPlan({2, 0, 1}).get());
    node->setNumNewParts(2);
    const osg::ref_ptr<LegoNode> copy = osg::clone(node.get(), osg::CopyOp::DEEP_COPY_ALL);
    EXPECT_EQ(copy->getBuildProgress(), 0.5);
    EXPECT_EQ(copy->getBuildingPlan(), node->getBuildingPlan());
    EXPECT_EQ(copy->getNumNewParts(), 2u);
}

} // namespace

} // namespace osgLego::test
