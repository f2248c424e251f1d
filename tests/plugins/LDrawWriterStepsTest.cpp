#include "WrittenLDraw.h"

#include <ldraw/LDrawWriter.h>
#include <osgLego/BuildingPlanner.h>

#include <sstream>

#include <gtest/gtest.h>
#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

/** The kinds of lines below the header: p for a part, the number of a submodel, | for the end of a step, and the text
 * of ROTSTEP; / starts a file. */
std::string summarize(const std::string& text)
{
    const std::string REFERENCE = "-sub-";
    std::string summary;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
    {
        line.erase(line.find_last_not_of('\r') + 1);
        if (line.starts_with("0 FILE "))
            summary += "/";
        else if (line == "0 STEP")
            summary += "|";
        else if (line.starts_with("0 ROTSTEP "))
            summary += line.substr(2);
        else if (const auto place = line.find(REFERENCE); line.starts_with("1 ") && place != std::string::npos)
            summary += line[place + REFERENCE.size()];
        else if (line.starts_with("1 "))
            summary += "p";
    }
    return summary;
}

/** A column of four bricks, from bottom to top in BrickModel::getParts(). */
osg::ref_ptr<LegoNode> createColumn()
{
    return createNode({1, 1, 4}, {makePart({0, 0, 0}, {1, 1, 1}, 1), makePart({0, 0, 1}, {1, 1, 1}, 2),
                                  makePart({0, 0, 2}, {1, 1, 1}, 4), makePart({0, 0, 3}, {1, 1, 1}, 14)});
}

TEST(LDrawWriterSteps, EndsTheStepsOfThePlanOfTheNode)
{
    const auto node = createColumn();
    node->setBuildingPlan(BuildingPlan::create(4, {{{0}, {}}, {{1, 2, 3}, {}}}));
    EXPECT_EQ(summarize(writeLDraw(*node).text), "p|ppp|");
    EXPECT_EQ(summarize(writeLDraw(*node, "a.mpd").text), "/p|ppp|");
}

TEST(LDrawWriterSteps, MakesAPlanOfItsOwnForNodesWithoutAFittingOne)
{
    const auto node = createColumn();
    node->setBuildingPlan(BuildingPlan::create(1, {{{0}, {}}}));
    EXPECT_EQ(summarize(writeLDraw(*node).text), "pppp|");
}

TEST(LDrawWriterSteps, SubmodelsOfThePlanAreFilesOfAnMpd)
{
    const auto node = createColumn();
    // The two upper bricks are a submodel, which contains a submodel with the highest brick.
    node->setBuildingPlan(
        BuildingPlan::create(4, {{{0, 1}, {}}, {{}, {1}}}, {{{{{3}, {}}}}, {{{{2}, {}}, {{}, {0}}}}}));
    const WrittenLDraw mpd = writeLDraw(*node, "a.mpd");
    EXPECT_EQ(summarize(mpd.text), "/pp|2|/p|/p|1|");
    EXPECT_EQ(mpd.getReferences(),
              (Lines{"1 1 0 -24 0 1 0 0 0 1 0 0 0 1 3005.dat", "1 2 0 -48 0 1 0 0 0 1 0 0 0 1 3005.dat",
                     "1 16 0 -48 0 1 0 0 0 1 0 0 0 1 a-sub-2.ldr", "1 14 0 -24 0 1 0 0 0 1 0 0 0 1 3005.dat",
                     "1 4 0 -24 0 1 0 0 0 1 0 0 0 1 3005.dat", "1 16 0 -24 0 1 0 0 0 1 0 0 0 1 a-sub-1.ldr"}))
        << "the origin is the centre of the lowest layer of each submodel";
    EXPECT_NE(mpd.text.find("0 FILE a-sub-1.ldr\r\n0 Model: A, a-sub-1.ldr\r\n0 Name: a-sub-1.ldr\r\n"),
              std::string::npos)
        << mpd.text;
    EXPECT_EQ(summarize(writeLDraw(*node).text), "pp|pp|") << "one file has the same order";
}

TEST(LDrawWriterSteps, SubmodelsAreCentredWhereverTheyAre)
{
    const auto node = createNode({8, 5, 2}, {makePart({0, 0, 0}, {8, 2, 1}, 1), makePart({5, 1, 1}, {3, 1, 1}, 2),
                                             makePart({7, 2, 1}, {1, 3, 1}, 4)});
    node->setBuildingPlan(BuildingPlan::create(3, {{{0}, {0}}}, {{{{{1, 2}, {}}}}}));
    EXPECT_EQ(writeLDraw(*node, "a.mpd").getReferences(),
              (Lines{"1 1 0 -24 -30 1 0 0 0 1 0 0 0 1 3007.dat", "1 16 50 -24 10 1 0 0 0 1 0 0 0 1 a-sub-1.ldr",
                     "1 2 0 -24 -30 1 0 0 0 1 0 0 0 1 3622.dat", "1 4 20 -24 10 0 0 1 0 1 0 -1 0 0 3622.dat"}));
}

TEST(LDrawWriterSteps, AChangedViewIsWrittenForTheStepThatItEnds)
{
    const auto node = createColumn();
    node->setBuildingPlan(
        BuildingPlan::create(4, {{{0}, {}}, {{1}, {}, 1}, {{2}, {}, 1}, {{}, {0}, 0}}, {{{{{3}, {}, 0, true}}}}));
    EXPECT_EQ(summarize(writeLDraw(*node, "a.mpd").text),
              "/p|pROTSTEP 0 90 0 REL|p|1ROTSTEP END|/pROTSTEP 180 90 0 REL|");
    EXPECT_EQ(summarize(writeLDraw(*node).text), "p|pROTSTEP 0 90 0 REL|p|pROTSTEP END|");
}

TEST(LDrawWriterSteps, SubmodelsDeeperThanReadersFollowAreWrittenWhereTheyAreAttached)
{
    std::vector<Part> parts;
    std::vector<Submodel> submodels;
    const std::uint32_t COUNT = 100;
    for (std::uint16_t index = 0; index < COUNT; ++index)
    {
        parts.push_back(makePart({0, 0, index}, {1, 1, 1}, index % 16));
        const std::uint32_t below = index;
        std::vector<std::uint32_t> inner;
        if (index > 0) inner.push_back(below - 1);
        submodels.push_back({{{{index}, inner}}});
    }
    const auto node = createNode({1, 1, 100}, parts);
    node->setBuildingPlan(BuildingPlan::create(COUNT, {{{}, {COUNT - 1}}}, submodels));
    const std::string summary = summarize(writeLDraw(*node, "a.mpd").text);
    EXPECT_EQ(std::count(summary.begin(), summary.end(), 'p'), COUNT);
    EXPECT_EQ(std::count(summary.begin(), summary.end(), '/'), 33);
}

TEST(LDrawWriterSteps, SubmodelsThatComeBeforeThoseTheyContainAreAsDeep)
{
    constexpr std::uint32_t COUNT = 40;
    std::vector<Part> parts;
    std::vector<Submodel> submodels;
    for (std::uint32_t index = 0; index < COUNT; ++index)
    {
        parts.push_back(makePart({0, 0, static_cast<std::uint16_t>(index)}, {1, 1, 1}, 1));
        Submodel& submodel = submodels.emplace_back();
        submodel.steps.emplace_back().parts = {index};
        if (index + 1 < COUNT) submodel.steps.back().submodels = {index + 1};
    }
    const auto node = createNode({1, 1, COUNT}, parts);
    node->setBuildingPlan(BuildingPlan::create(COUNT, {{{}, {0}}}, submodels));
    const std::string summary = summarize(writeLDraw(*node, "a.mpd").text);
    EXPECT_EQ(std::count(summary.begin(), summary.end(), 'p'), COUNT);
    EXPECT_EQ(std::count(summary.begin(), summary.end(), '/'), 33) << "the file of the model and 32 of submodels";
}

TEST(LDrawWriterSteps, SeveralNodesOfAnMpdHaveSubmodelsOfTheirOwn)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (int index = 0; index < 2; ++index)
    {
        const auto node = createColumn();
        node->setBuildingPlan(BuildingPlan::create(4, {{{0, 1}, {0}}}, {{{{{2, 3}, {}}}}}));
        group->addChild(node);
    }
    const WrittenLDraw written = writeLDraw(*group, "a.mpd");
    EXPECT_EQ(summarize(written.text), "/pp|/pp1|/pp|/pp1|/pp|");
    EXPECT_NE(written.text.find("0 FILE a-2-sub-1.ldr\r\n"), std::string::npos);
}

/** The lines of the base plate below parts in two corners of a model. @param footprint in cells. */
Lines placePlates(const glm::ivec2& footprint, UpAxis up = UpAxis::Z)
{
    const std::size_t across = up == UpAxis::Z ? 1 : 2;
    glm::ivec3 dimensions(footprint.x, 1, 1);
    dimensions[static_cast<int>(across)] = footprint.y;
    Part corner = makePart({0, 0, 0}, {1, 1, 1}, 1);
    corner.cell[0] = static_cast<std::uint16_t>(footprint.x - 1);
    corner.cell[across] = static_cast<std::uint16_t>(footprint.y - 1);
    const auto node = createNode(dimensions, {makePart({0, 0, 0}, {1, 1, 1}, 1), corner}, 1.2, up);
    Lines plates;
    for (const std::string& line : writeLDraw(*node, "a.ldr", {{}, true}).getReferences())
        if (line.starts_with("1 2 ")) plates.push_back(line);
    return plates;
}

TEST(LDrawWriterSteps, ABasePlateLiesBelowTheMiddleOfTheModel)
{
    // 2 of 16 studs are to the left of 11, and 2 of 8 before 3.
    EXPECT_EQ(placePlates({11, 3}), Lines{"1 2 10 0 10 1 0 0 0 1 0 0 0 1 3865.dat"});
    EXPECT_EQ(placePlates({3, 11}), Lines{"1 2 10 0 10 0 0 1 0 1 0 -1 0 0 3865.dat"});
    EXPECT_EQ(placePlates({11, 3}, UpAxis::Y), Lines{"1 2 10 0 -10 1 0 0 0 1 0 0 0 1 3865.dat"})
        << "rows are counted from the other end";
}

TEST(LDrawWriterSteps, SeveralBasePlatesLieBesideEachOther)
{
    EXPECT_EQ(placePlates({60, 50}),
              (Lines{"1 2 -320 0 -320 1 0 0 0 1 0 0 0 1 3811.dat", "1 2 320 0 -320 1 0 0 0 1 0 0 0 1 3811.dat",
                     "1 2 -320 0 320 1 0 0 0 1 0 0 0 1 3811.dat", "1 2 320 0 320 1 0 0 0 1 0 0 0 1 3811.dat"}));
}

TEST(LDrawWriterSteps, BasePlatesMoveAndTurnWithTheirModels)
{
    // One brick, and one that is 40 studs to the right and turned by a quarter, on plates of 8 x 16.
    const auto node = createNode({4, 2, 1}, {makePart({0, 0, 0}, {4, 2, 1}, 1)});
    osg::ref_ptr<osg::MatrixTransform> turned =
        new osg::MatrixTransform(osg::Matrix::rotate(osg::PI_2, osg::Z_AXIS) * osg::Matrix::translate(40.0, 0.0, 0.0));
    turned->addChild(node);
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(node);
    group->addChild(turned);
    const Lines lines = writeLDraw(*group, "a.ldr", {{}, true}).getReferences();
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(lines[0], "1 2 0 0 0 1 0 0 0 1 0 0 0 1 3865.dat");
    // The centre of the model, at 2 and 1 studs, turns to -1 and 2.
    EXPECT_EQ(lines[2], "1 2 740 0 20 0 0 -1 0 1 0 1 0 0 3865.dat");
    EXPECT_EQ(lines[3], "1 1 740 -24 20 0 0 -1 0 1 0 1 0 0 3001.dat");
}

TEST(LDrawWriterSteps, CheckNoticesBasePlatesThatAreMissingAndTooMany)
{
    const auto node = createColumn();
    const WrittenLDraw without = writeLDraw(*node, "a.ldr");
    const WrittenLDraw with = writeLDraw(*node, "a.ldr", {{}, true});
    const LDrawWriter writer(with.scene, "a.ldr", {{}, true});
    EXPECT_EQ(writer.check(with.text), "");
    EXPECT_EQ(writer.check(without.text), "the file, read back, has other base plates");
    EXPECT_EQ(LDrawWriter(with.scene, "a.ldr").check(with.text), "the file, read back, has other base plates");
}

TEST(LDrawWriterSteps, ABasePlateBeginsTheFirstStepOfEachModelInAnMpd)
{
    const auto node = createColumn();
    node->setBuildingPlan(BuildingPlan::create(4, {{{0, 1}, {}}, {{}, {0}}}, {{{{{2, 3}, {}}}}}));
    const LDrawWriteOptions onPlate{{}, true};
    EXPECT_EQ(summarize(writeLDraw(*node, "a.mpd", onPlate).text), "/ppp|1|/pp|");
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(node);
    group->addChild(createColumn());
    EXPECT_EQ(summarize(writeLDraw(*group, "a.mpd", onPlate).text), "/pp|/ppp|1|/pp|/ppppp|");
}

} // namespace

} // namespace osgLego::test
