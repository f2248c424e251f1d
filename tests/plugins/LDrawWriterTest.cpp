#include "WrittenLDraw.h"

#include <ldraw/LDrawParser.h>
#include <ldraw/LDrawScene.h>
#include <ldraw/LDrawWriter.h>

#include <osgLego/BuildingPlanner.h>
#include <osgLego/LegoNode.h>

#include <Meshes.h>
#include <PartModels.h>
#include <Settings.h>
#include <TemporaryFolder.h>

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <osg/MatrixTransform>
#include <osg/Switch>

namespace osgLego::test
{

namespace
{

TEST(LDrawWriter, PlacesTheTopOfEachPartWithItsLongSideAlongItsAxis)
{
    // A 2 x 4 brick along x on the floor, and above its left end a 2 x 3 along y.
    const auto node = createNode({4, 3, 2}, {makePart({0, 0, 0}, {4, 2, 1}, 4), makePart({0, 0, 1}, {2, 3, 1}, 14)});
    EXPECT_EQ(writeLDraw(*node).getReferences(),
              (Lines{"1 4 0 -24 -10 1 0 0 0 1 0 0 0 1 3001.dat", "1 14 -20 -48 0 0 0 1 0 1 0 -1 0 0 3002.dat"}));
}

TEST(LDrawWriter, WritesTheSameFileForModelsWithYUpwards)
{
    // The brick above, turned so that the model's y is up and z towards the viewer: depth y becomes -z.
    const auto node =
        createNode({4, 2, 3}, {makePart({0, 0, 1}, {4, 1, 2}, 4), makePart({0, 1, 0}, {2, 1, 3}, 14)}, 1.2, UpAxis::Y);
    EXPECT_EQ(writeLDraw(*node).getReferences(),
              (Lines{"1 4 0 -24 -10 1 0 0 0 1 0 0 0 1 3001.dat", "1 14 -20 -48 0 0 0 1 0 1 0 -1 0 0 3002.dat"}));
}

TEST(LDrawWriter, TheOriginIsTheCentreOfTheLowestPartsWhereverTheyAreInTheGrid)
{
    const auto node = createNode({40, 30, 20}, {makePart({21, 11, 7}, {1, 2, 1}, 0)});
    EXPECT_EQ(writeLDraw(*node).getReferences(), (Lines{"1 0 0 -24 0 0 0 1 0 1 0 -1 0 0 3004.dat"}));
}

TEST(LDrawWriter, CountsHeightsInPlates)
{
    const auto node = createNode(
        {1, 1, 5},
        {makePart({0, 0, 0}, {1, 1, 1}, 1), makePart({0, 0, 1}, {1, 1, 3}, 2), makePart({0, 0, 4}, {1, 1, 1}, 1)}, 0.4);
    EXPECT_EQ(writeLDraw(*node).getReferences(),
              (Lines{"1 1 0 -8 0 1 0 0 0 1 0 0 0 1 3024.dat", "1 2 0 -32 0 1 0 0 0 1 0 0 0 1 3005.dat",
                     "1 1 0 -40 0 1 0 0 0 1 0 0 0 1 3024.dat"}));
}

TEST(LDrawWriter, EachNodeOfAnMpdHasItsOwnParts)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 4)}));
    group->addChild(createNode({2, 1, 1}, {makePart({0, 0, 0}, {2, 1, 1}, 1)}));
    const std::string text = writeLDraw(*group, "a.mpd").text;
    const auto second = text.find("0 FILE a-2.ldr");
    EXPECT_LT(text.find("3005.dat"), second);
    EXPECT_LT(second, text.find("3004.dat"));
}

TEST(LDrawWriter, PlacesNodesInALatticeOfTheWorld)
{
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<osg::Group> expected = new osg::Group;
    for (const double place : {0.0, 3.0})
    {
        const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("cell=0.3,anchor=world,parts=bricks"));
        lego->addChild(createSphere(8));
        const osg::ref_ptr<osg::MatrixTransform> above = new osg::MatrixTransform(
            osg::Matrixd::rotate(place, osg::Vec3d(1, 2, 3)) * osg::Matrixd::translate(place, 0, 0));
        above->addChild(lego);
        scene->addChild(above);
        expected->addChild(createStoredNode(*lego->getBricks(), "parts=bricks"));
    }
    EXPECT_EQ(writeLDraw(*scene, "a.mpd").getReferences(), writeLDraw(*expected, "a.mpd").getReferences());
}

TEST(LDrawWriter, WritesColoursWithoutACodeDirectly)
{
    Part part = makePart({0, 0, 0}, {1, 1, 1}, Part::NO_CODE);
    part.color = {1, 171, 255};
    const WrittenLDraw written = writeLDraw(*createNode({1, 1, 1}, {part}));
    EXPECT_EQ(written.getReferences(), (Lines{"1 0x201abff 0 -24 0 1 0 0 0 1 0 0 0 1 3005.dat"}));
    EXPECT_EQ(written.scene.warnings, (Lines{"never made in this size and colour: 1 part (Brick 1 x 1 in #01ABFF)"}));
}

TEST(LDrawWriter, TheHeaderNamesTitleFileAuthorAndSettings)
{
    const auto node = createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 1)});
    node->setName("/models/two\nlines"); // a title without folders can be published
    const Lines lines = writeLDraw(*node, "/some/where/My Car.LDR").getLines('0');
    ASSERT_GE(lines.size(), 6u);
    EXPECT_EQ(lines[0], "0 Model: Two Lines");
    EXPECT_EQ(lines[1], "0 Name: My Car.ldr");
    EXPECT_EQ(lines[2], "0 Author: osgLego");
    EXPECT_EQ(lines[4], "0 // Settings of osgLego: " + node->getSettings().toString());
}

TEST(LDrawWriter, TheHeaderHasALicenceOnlyIfOneIsGiven)
{
    const auto node = createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 1)});
    const WrittenLDraw written = writeLDraw(*node);
    EXPECT_EQ(written.text.find("LICENSE"), std::string::npos);
    ModelHeader header;
    header.title = "my_car";
    header.author = "Ann\nSmith";
    header.license = "Licensed under CC BY 4.0 : see CAreadme.txt";
    std::ostringstream stream;
    LDrawWriter(written.scene, "a.ldr", {header, false}).write(stream);
    for (const char* line : {"0 Model: my_car\r\n", "0 Author: Ann Smith\r\n",
                             "0 !LICENSE Licensed under CC BY 4.0 : see CAreadme.txt\r\n"})
        EXPECT_NE(stream.str().find(line), std::string::npos) << stream.str();
}

TEST(LDrawWriter, KeepsTheTextsOfTheFileThatWasReadUnlessOthersAreGiven)
{
    const auto node = createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 1)});
    ModelHeader{"My car", "Ann Lee", "CC0"}.store(*node);
    const WrittenLDraw written = writeLDraw(*node, "a.mpd");
    for (const char* line : {"0 Model: My car\r\n", "0 Author: Ann Lee\r\n", "0 !LICENSE CC0\r\n"})
        EXPECT_NE(written.text.find(line), std::string::npos) << written.text;
    std::ostringstream stream;
    LDrawWriter(written.scene, "a.mpd", {{"", "Bob", ""}, false}).write(stream);
    for (const char* line : {"0 Model: My car\r\n", "0 Author: Bob\r\n", "0 !LICENSE CC0\r\n"})
        EXPECT_NE(stream.str().find(line), std::string::npos) << stream.str();
}

TEST(LDrawWriter, NamesOfNodesAndFilesAreNeverCommands)
{
    const auto node = createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 4)});
    for (const char* name : {"NOFILE", " NOFILE", "FILE x", "!COLOUR Blue CODE 4 VALUE #0000FF EDGE #000000"})
        for (const char* file : {"a.ldr", "a.mpd", "NOFILE.ldr", "FILE x.mpd"})
        {
            node->setName(name);
            const WrittenLDraw written = writeLDraw(*node, file);
            std::string error;
            const std::optional<LDrawDocument> document = LDrawParser::parse(written.text, error);
            ASSERT_TRUE(document) << error;
            EXPECT_TRUE(document->getColors().empty()) << written.text;
        }
    node->setName("");
    writeLDraw(*node, "NOFILE.ldr");
}

TEST(LDrawWriter, LongNamesAreCutBetweenCharacters)
{
    const auto node = createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 4)});
    std::string name;
    for (int index = 0; index < 40'000; ++index)
        name += "\u00e4"; // two bytes
    node->setName(name);
    const Lines lines = writeLDraw(*node).getLines('0');
    EXPECT_EQ(lines[0], "0 Model: " + name.substr(0, 192)) << "200 bytes would end inside a character";
}

TEST(LDrawWriter, LongNamesDoNotEndWithASpace)
{
    const auto node = createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 4)});
    const std::string word(192, 'A');
    node->setName(word + " b");
    const Lines lines = writeLDraw(*node).getLines('0');
    EXPECT_EQ(lines[0], "0 Model: " + word) << "a reader trims the line, and the next writer would write another one";
}

TEST(LDrawWriter, RandomModelsOfEverySizeSurvive)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
        for (std::uint32_t seed = 1; seed < 6; ++seed)
        {
            PartFilling filling;
            filling.heights = {1, 3};
            filling.colors = {{0x1b, 0x2a, 0x34}, {0x1e, 0x5a, 0xa8}, {0x00, 0x85, 0x2b}};
            filling.seed = seed;
            filling.isCovered = [](const glm::ivec3& cell) { return (cell.x + cell.y) % 11 != 0; };
            const auto model = createParts(createPartGrid({17, 14, 15}, 0.4, up), filling);
            const auto node = createStoredNode(*model, "parts=bricks,proportions=plate");
            PlanningOptions options;
            options.checksStability = false;
            node->setBuildingPlan(planBuilding(*model, options));
            EXPECT_EQ(writeLDraw(*node).getReferences().size(), model->getParts().size());
            const WrittenLDraw mpd = writeLDraw(*node, "a.mpd");
            std::size_t numParts = 0;
            for (const std::string& line : mpd.getReferences())
                numParts += line.ends_with(".dat") ? 1 : 0;
            EXPECT_EQ(numParts, model->getParts().size());
        }
}

TEST(LDrawWriter, CheckNoticesEveryKindOfDifference)
{
    const auto node = createNode({4, 3, 2}, {makePart({0, 0, 0}, {4, 2, 1}, 4), makePart({0, 0, 1}, {2, 3, 1}, 14)});
    const WrittenLDraw written = writeLDraw(*node);
    const LDrawWriter writer(written.scene, "a.ldr");
    const auto isNoticed = [&](const std::string& from, const std::string& to)
    {
        std::string text = written.text;
        const auto place = text.find(from);
        EXPECT_NE(place, std::string::npos) << from;
        return !writer.check(text.replace(place, from.size(), to)).empty();
    };
    EXPECT_TRUE(isNoticed("1 14 ", "1 15 ")) << "a colour";
    EXPECT_TRUE(isNoticed("-20 -48 0", "0 -48 0")) << "a place";
    EXPECT_TRUE(isNoticed("-20 -48 0", "-20 -72 0")) << "a height";
    EXPECT_TRUE(isNoticed("0 0 1 0 1 0 -1 0 0 3002", "1 0 0 0 1 0 0 0 1 3002")) << "a direction";
    EXPECT_TRUE(isNoticed("3001.dat", "3002.dat")) << "a part";
    EXPECT_TRUE(isNoticed("3001.dat", "3024x.dat")) << "an unknown part";
    EXPECT_TRUE(isNoticed("1 4 0", "0 4 0")) << "a missing part";
    EXPECT_TRUE(isNoticed("0 STEP", "1 4 80 -24 0 1 0 0 0 1 0 0 0 1 3005.dat\r\n0 STEP")) << "another part";
    EXPECT_TRUE(isNoticed("1 4 0", "x 4 0")) << "a damaged line";
}

osg::ref_ptr<osg::Group> createPair(const osg::ref_ptr<LegoNode>& node, const osg::Matrixd& second)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(node);
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(second);
    transform->addChild(node);
    group->addChild(transform);
    return group;
}

TEST(LDrawWriter, MpdHasOneSubmodelForANodeInTwoPlaces)
{
    const auto node = createNode({2, 1, 1}, {makePart({0, 0, 0}, {2, 1, 1}, 4)});
    // Five studs to the right, two behind and one brick up, and turned by 90 degrees to the left, seen from above.
    const auto group =
        createPair(node, osg::Matrixd::rotate(osg::PI_2, 0, 0, 1) * osg::Matrixd::translate(5.0, 2.0, 1.2));
    const WrittenLDraw written = writeLDraw(*group, "pair.mpd");
    // The centre (1, 0.5) of the node goes to (4.5, 3): from (1, 0.5), 3.5 to the right and 2.5 behind.
    EXPECT_EQ(written.getReferences(),
              (Lines{"1 16 0 0 0 1 0 0 0 1 0 0 0 1 pair-1.ldr", "1 16 70 -24 50 0 0 -1 0 1 0 1 0 0 pair-1.ldr",
                     "1 4 0 -24 0 1 0 0 0 1 0 0 0 1 3004.dat"}));
    EXPECT_NE(written.text.find("0 FILE pair.ldr\r\n"), std::string::npos);
    EXPECT_NE(written.text.find("0 FILE pair-1.ldr\r\n"), std::string::npos);
}

TEST(LDrawWriter, AFileOfSeveralModelsHasTheTextsThatAllOfThemShare)
{
    const auto ofAnn = createNode({2, 1, 1}, {makePart({0, 0, 0}, {2, 1, 1}, 4)});
    const auto ofBob = createNode({2, 1, 1}, {makePart({0, 0, 0}, {2, 1, 1}, 4)});
    ofAnn->setName("old_car.ldr");
    ModelHeader{"Old car", "Ann", "CC0"}.store(*ofAnn);
    ModelHeader{"New car", "Bob", "CC0"}.store(*ofBob);
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(ofAnn);
    const osg::ref_ptr<osg::MatrixTransform> transform =
        new osg::MatrixTransform(osg::Matrixd::translate(5.0, 0.0, 0.0));
    transform->addChild(ofBob);
    group->addChild(transform);
    for (const char* name : {"both.mpd", "both.ldr"})
    {
        std::string error;
        const std::optional<LDrawDocument> document = LDrawParser::parse(writeLDraw(*group, name).text, error);
        ASSERT_TRUE(document) << error;
        EXPECT_EQ(document->getHeader().title, "Both");
        EXPECT_EQ(document->getHeader().author, "");
        EXPECT_EQ(document->getHeader().license, "CC0");
    }
    ModelHeader{"", "", "All rights reserved"}.store(*ofBob);
    EXPECT_EQ(writeLDraw(*group, "both.ldr").text.find("!LICENSE"), std::string::npos);
    const std::string text = writeLDraw(*group, "both.mpd").text;
    for (const char* line :
         {"0 Author: Ann\r\n", "0 Author: Bob\r\n", "0 !LICENSE CC0\r\n", "0 !LICENSE All rights reserved\r\n"})
        EXPECT_NE(text.find(line), std::string::npos) << text;
    std::string error;
    EXPECT_EQ(LDrawParser::parse(text, error)->getHeader().license, "");
}

TEST(LDrawWriter, LdrHasThePartsOfAllPlacesAndInclinedNodesKeepTheirMatrix)
{
    const auto node = createNode({2, 1, 1}, {makePart({0, 0, 0}, {2, 1, 1}, 4)});
    const auto group =
        createPair(node, osg::Matrixd::rotate(std::atan2(3.0, 4.0), 0, 0, 1) * osg::Matrixd::translate(10.0, 0.0, 0.0));
    const Lines lines = writeLDraw(*group).getReferences();
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0], "1 4 0 -24 0 1 0 0 0 1 0 0 0 1 3004.dat");
    // (1, 0.5) turned is (0.5, 1); 9.5 to the right of the first centre, and 0.5 behind.
    EXPECT_EQ(lines[1], "1 4 190 -24 10 0.8 0 -0.6 0 1 0 0.6 0 0.8 3004.dat");
}

TEST(LDrawWriter, BricksOfAnotherSizeThanTheFirstAreReported)
{
    const auto node = createNode({2, 1, 1}, {makePart({0, 0, 0}, {2, 1, 1}, 4)});
    const auto warningsWith = [&](const osg::Matrixd& matrix)
    {
        LDrawScene scene;
        std::string error;
        EXPECT_TRUE(LDrawScene::create(*createPair(node, matrix), scene, error)) << error;
        return scene.warnings;
    };
    EXPECT_TRUE(warningsWith(osg::Matrixd::rotate(0.3, 0, 0, 1) * osg::Matrixd::translate(10, 0, 0)).empty());
    const auto warnings = warningsWith(osg::Matrixd::scale(0.5, 0.5, 0.5) * osg::Matrixd::translate(10, 0, 0));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0], "1 node has bricks of another size than the first, which exist in one size only; expected "
                           "equal cells, as with cell=");
}

TEST(LDrawWriter, ATransformAboveTheOnlyNodeDoesNotTurnItsStuds)
{
    osg::ref_ptr<osg::MatrixTransform> transform =
        new osg::MatrixTransform(osg::Matrixd::rotate(1.0, 1, 1, 0) * osg::Matrixd::scale(3, 3, 3));
    transform->addChild(createNode({2, 1, 1}, {makePart({0, 0, 0}, {2, 1, 1}, 4)}));
    EXPECT_EQ(writeLDraw(*transform).getReferences(), (Lines{"1 4 0 -24 0 1 0 0 0 1 0 0 0 1 3004.dat"}));
}

TEST(LDrawWriter, HiddenNodesAreNotWritten)
{
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    choice->addChild(createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 4)}), false);
    choice->addChild(createNode({2, 1, 1}, {makePart({0, 0, 0}, {2, 1, 1}, 4)}), true);
    EXPECT_EQ(writeLDraw(*choice).getReferences(), (Lines{"1 4 0 -24 0 1 0 0 0 1 0 0 0 1 3004.dat"}));
}

TEST(LDrawWriter, CellsBecomeSingleBricksOfThePaletteWithAWarning)
{
    const auto model =
        BrickModel::create(createPartGrid({2, 1, 1}, 1.2), {{{0, 0, 0}, {0x1e, 0x5a, 0xa8}}, {{1, 0, 0}, {1, 2, 3}}});
    const WrittenLDraw written = writeLDraw(*createStoredNode(*model, "proportions=brick,palette=ldraw"));
    EXPECT_EQ(written.getReferences(),
              (Lines{"1 1 -10 -24 0 1 0 0 0 1 0 0 0 1 3005.dat", "1 0x2010203 10 -24 0 1 0 0 0 1 0 0 0 1 3005.dat"}));
    ASSERT_EQ(written.scene.warnings.size(), 2u);
    EXPECT_EQ(written.scene.warnings[0],
              "the model has cells instead of parts, and each of them is written as a part of "
              "1 x 1; expected parts=bricks");
}

TEST(LDrawWriter, SizesThatWereNeverMadeInAColourAreReported)
{
    // 3, Dark_Turquoise: no brick of 2 x 3 and of 2 x 8.
    const auto node = createNode({8, 2, 3}, {makePart({0, 0, 0}, {8, 2, 1}, 3), makePart({0, 0, 1}, {8, 2, 1}, 3),
                                             makePart({0, 0, 2}, {2, 2, 1}, 3)});
    const WrittenLDraw written = writeLDraw(*node);
    ASSERT_EQ(written.scene.warnings.size(), 1u);
    EXPECT_EQ(written.scene.warnings[0], "never made in this size and colour: 2 parts (Brick 2 x 8 in Dark_Turquoise)");
}

/** Models whose palette was a file in the test's folder. */
class LDrawWriterPalette : public TemporaryFolderTest
{
protected:
    /** Write a model whose palette is removed before. */
    Lines warningsOf(const BrickModel& model, const std::string& settings)
    {
        std::ofstream(pathOf("p.ldr")) << "0 !COLOUR Red CODE 4 VALUE #C91A09 EDGE #333333\n";
        const auto node = createStoredNode(model, settings + ",palette=" + pathOf("p.ldr"));
        std::filesystem::remove(pathOf("p.ldr"));
        return writeLDraw(*node).scene.warnings;
    }

    std::string missing() const { return pathOf("p.ldr") + ": the palette can't be read: No such file or directory"; }
};

TEST_F(LDrawWriterPalette, TheErrorOfAMissingPaletteIsReportedForCells)
{
    const auto model = BrickModel::create(createPartGrid({1, 1, 1}, 1.2), {{{0, 0, 0}, {0xc9, 0x1a, 0x09}}});
    const Lines warnings = warningsOf(*model, "proportions=brick");
    ASSERT_FALSE(warnings.empty());
    EXPECT_EQ(warnings[0], missing() + "; its colours are written directly, without codes");
}

TEST_F(LDrawWriterPalette, TheErrorOfAMissingPaletteIsReportedForParts)
{
    const auto model = BrickModel::createOfParts(createPartGrid({1, 1, 1}, 1.2), {makePart({0, 0, 0}, {1, 1, 1}, 4)});
    EXPECT_EQ(warningsOf(*model, "proportions=brick,parts=bricks"),
              (Lines{missing() + "; the built-in colours tell which parts were made"}));
}

std::string errorOf(const osg::Node& node)
{
    LDrawScene scene;
    std::string error;
    EXPECT_FALSE(LDrawScene::create(node, scene, error));
    return error;
}

TEST(LDrawWriter, ModelsThatPartsCannotRepresentAreRefused)
{
    EXPECT_EQ(errorOf(*osg::ref_ptr<osg::Group>(new osg::Group)),
              "there are no bricks in it; expected a LegoNode, as from MESH.legolize");
    EXPECT_EQ(errorOf(*osg::ref_ptr<LegoNode>(new LegoNode)), "the model has no bricks");
    const auto cubes = BrickModel::create(createPartGrid({1, 1, 1}), {{{0, 0, 0}, {1, 2, 3}}});
    EXPECT_EQ(errorOf(*createStoredNode(*cubes, "8")),
              "the model consists of cells that no real part has the shape of; expected proportions=brick or plate, or "
              "parts=bricks");
    EXPECT_EQ(errorOf(*createNode({5, 1, 1}, {makePart({0, 0, 0}, {5, 1, 1}, 4)})),
              "the model has a part of 5 x 1 x 1 cells, which does not exist; expected sizes from 1x1 to 2x8");
    const auto node = createNode({1, 1, 1}, {makePart({0, 0, 0}, {1, 1, 1}, 4)});
    EXPECT_EQ(errorOf(*createPair(node, osg::Matrixd::scale(1, 1, 0))),
              "the model is below a transform without an inverse; expected one that keeps volumes");
}

TEST(LDrawWriter, WarnsOfStepsOfWhichItDidNotComputeWhetherTheModelStands)
{
    const auto warningsOf = [](int numParts)
    {
        std::vector<Part> parts;
        for (int index = 0; index < numParts; ++index)
            parts.push_back(makePart(
                {static_cast<std::uint16_t>(index % 100), static_cast<std::uint16_t>(index / 100), 0}, {1, 1, 1}, 4));
        LDrawScene scene;
        std::string error;
        EXPECT_TRUE(LDrawScene::create(*createNode({100, 100, 1}, std::move(parts)), scene, error)) << error;
        return scene.warnings;
    };
    EXPECT_TRUE(warningsOf(200).empty());
    const std::vector<std::string> warnings = warningsOf(static_cast<int>(LDrawModel::MOST_CHECKED) + 1);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("it was not computed whether"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("expected at most 5000 parts"), std::string::npos) << warnings[0];
}

} // namespace

} // namespace osgLego::test
