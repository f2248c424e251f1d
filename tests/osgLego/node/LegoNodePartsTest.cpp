#include <osgLego/CpuLegolizer.h>
#include <osgLego/LegoNode.h>

#include <common/RacingCar.h>

#include <Meshes.h>
#include <Notices.h>
#include <Settings.h>
#include <TemporaryFolder.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/Optimizer>

namespace osgLego::test
{

namespace
{

TEST(LegoNodeParts, ANodeShowsThePartsThatTheCpuLays)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("24,parts=bricks"));
    lego->addChild(createRacingCar());
    EXPECT_EQ(lego->getBricks()->getParts(),
              legolizeOnCpu(*createRacingCar(), parseSettings("24,parts=bricks"))->getParts());
    EXPECT_TRUE(lego->setSettings(parseSettings("24,proportions=brick")));
    EXPECT_TRUE(lego->getBricks()->getParts().empty());
}

TEST(LegoNodeParts, AMissingPaletteIsReportedAndChangesNothing)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("24"));
    bool isSet = true;
    const std::string notices =
        noticesOf([&] { isSet = lego->setSettings(parseSettings("24,palette=no-such-palette.csv")); });
    EXPECT_FALSE(isSet);
    EXPECT_NE(notices.find("no-such-palette.csv"), std::string::npos) << notices;
    EXPECT_EQ(lego->getSettings(), parseSettings("24"));
    osg::ref_ptr<const BrickModel> model;
    EXPECT_NE(
        noticesOf([&] { model = legolizeOnCpu(*createSphere(), parseSettings("24,palette=no-such-palette.csv")); })
            .find("no-such-palette.csv"),
        std::string::npos);
    EXPECT_FALSE(model);
}

std::set<std::array<std::uint8_t, 3>> partColorsOf(const BrickModel& model)
{
    std::set<std::array<std::uint8_t, 3>> colors;
    for (const Brick& brick : model.getBricks())
        colors.insert(brick.color);
    return colors;
}

class LegoNodePalette : public TemporaryFolderTest
{
};

TEST_F(LegoNodePalette, IsReadWhenItIsSetAndNotAgainForAChangedSource)
{
    const std::string file = pathOf("palette.csv");
    const auto write = [&](const char* color)
    {
        std::ofstream(file) << "code,name,rgb,edge,bricklink,bricks,plates\n4,One,#" << color
                            << ",#333333,5,11111111111,11111111111\n";
    };
    write("C91A09");
    osg::ref_ptr<LegoNode> lego = new LegoNode;
    ASSERT_TRUE(lego->setSettings(parseSettings("12,palette=" + file)));
    const osg::ref_ptr<LegoNode> copy = new LegoNode(*lego);
    std::filesystem::remove(file);
    for (LegoNode* node : {lego.get(), copy.get()})
    {
        node->addChild(createSphere());
        ASSERT_TRUE(node->getBricks()) << node->getObstacle();
        EXPECT_EQ(partColorsOf(*node->getBricks()), (std::set<std::array<std::uint8_t, 3>>{{0xC9, 0x1A, 0x09}}));
    }
    write("0055BF");
    lego->dirty();
    EXPECT_EQ(partColorsOf(*lego->getBricks()), (std::set<std::array<std::uint8_t, 3>>{{0xC9, 0x1A, 0x09}}));
    ASSERT_TRUE(lego->setSettings(lego->getSettings()));
    EXPECT_EQ(partColorsOf(*lego->getBricks()), (std::set<std::array<std::uint8_t, 3>>{{0x00, 0x55, 0xBF}}));
}

/** A node whose interior has too many cells. */
osg::ref_ptr<LegoNode> createTooLarge()
{
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("600,fill=solid"));
    lego->addChild(createSphere(6));
    return lego;
}

TEST(LegoNodeParts, ANodeThatCannotBeFilledHasNoBricksAndSaysWhyAlsoAfterPicking)
{
    const osg::ref_ptr<LegoNode> lego = createTooLarge();
    EXPECT_EQ(lego->getObstacle(), "");
    EXPECT_FALSE(lego->getBricks());
    EXPECT_NE(lego->getObstacle().find("cells; expected at most 67108864"), std::string::npos);
    osg::ref_ptr<osgUtil::LineSegmentIntersector> line =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(0, -5, 0), osg::Vec3d(0, 5, 0));
    osgUtil::IntersectionVisitor visitor(line);
    lego->accept(visitor);
    EXPECT_FALSE(lego->getBricks());
    EXPECT_NE(lego->getObstacle(), "");
    EXPECT_TRUE(lego->setSettings(parseSettings("16,fill=solid")));
    EXPECT_TRUE(lego->getBricks());
    EXPECT_EQ(lego->getObstacle(), "");
}

TEST(LegoNodeParts, AVisitorThatNeedsNoTrianglesDoesNotWaitForParts)
{
    const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("400,parts=bricks,fill=solid,effort=best"));
    lego->addChild(createSphere());
    osgUtil::Optimizer optimizer;
    optimizer.optimize(lego);
    EXPECT_TRUE(lego->getBound().valid());
    EXPECT_EQ(lego->getProgress().stage, LegoProgress::Stage::IDLE);
    EXPECT_FALSE(lego->getShownBricks());
}

TEST(LegoNodeParts, BeforeTheFirstBricksPickingFindsThePicture)
{
    for (const char* meanwhile : {"source", "nothing", "wait"})
    {
        const osg::ref_ptr<LegoNode> lego =
            new LegoNode(parseSettings(std::string("8,parts=bricks,meanwhile=") + meanwhile));
        lego->addChild(createSphere());
        const osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
            new osgUtil::LineSegmentIntersector(osg::Vec3d(0.05, 0.05, 9), osg::Vec3d(0.05, 0.05, -9));
        osgUtil::IntersectionVisitor visitor(ray);
        lego->accept(visitor);
        ASSERT_EQ(ray->containsIntersections(), meanwhile != std::string("nothing")) << meanwhile;
        if (!ray->containsIntersections()) continue;
        const double height = ray->getFirstIntersection().getWorldIntersectPoint().z();
        if (meanwhile == std::string("source"))
            EXPECT_LT(height, 1.0) << "the sphere";
        else
            EXPECT_GT(height, 1.0) << "a stud above it";
    }
}

TEST(LegoNodeParts, PickingUsesThePartsThatWereLaid)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("16,parts=bricks,colors=2"));
    lego->addChild(createSphere());
    const osg::ref_ptr<const BrickModel> model = lego->getBricks();
    osg::ref_ptr<osgUtil::LineSegmentIntersector> line =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(0, -5, 0), osg::Vec3d(0, 5, 0));
    osgUtil::IntersectionVisitor visitor(line);
    lego->accept(visitor);
    EXPECT_TRUE(line->containsIntersections());
    EXPECT_EQ(lego->getBricks(), model);
}

} // namespace

} // namespace osgLego::test
