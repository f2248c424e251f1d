#include "BookletModels.h"

#include <booklet/Base64.h>
#include <booklet/BookletText.h>

#include <PartModels.h>
#include <common/ColorName.h>
#include <osgLego/Palette.h>

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

PartsList::Row createRow(PartFamily family, int width, int length, const std::string& color)
{
    PartsList::Row row;
    row.type = findPartType(family, width, length);
    row.color.name = color;
    row.color.code = 4;
    return row;
}

} // namespace

TEST(Base64Test, EncodesTheExamplesOfTheStandard)
{
    EXPECT_EQ(toBase64(""), "");
    EXPECT_EQ(toBase64("f"), "Zg==");
    EXPECT_EQ(toBase64("fo"), "Zm8=");
    EXPECT_EQ(toBase64("foo"), "Zm9v");
    EXPECT_EQ(toBase64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(toBase64("\xff\xfe\xfd"), "//79");
}

TEST(BookletTextTest, DescribesPartsInASentence)
{
    EXPECT_EQ(describeParts(createRow(PartFamily::BRICK, 2, 4, "Dark_Red"), 2), "2 dark red bricks 2 x 4");
    EXPECT_EQ(describeParts(createRow(PartFamily::PLATE, 1, 1, "White"), 1), "1 white plate 1 x 1");
}

TEST(BookletTextTest, CountsWhatAStepAdds)
{
    const auto countOfStep = [](const BookletModel& model, std::size_t step)
    { return describeCount(model, model.getMainChapter().steps[step]); };
    const BookletModel tower = test::createTower();
    EXPECT_EQ(countOfStep(tower, 0), "2 parts");
    EXPECT_EQ(countOfStep(tower, 1), "A");
    EXPECT_EQ(countOfStep(test::createTower({.hasTwoSubmodels = true}), 1), "A + B");
    EXPECT_EQ(countOfStep(test::createTwins(), 1), "2 × A");
}

TEST(BookletTextTest, NotesPartsThatArePressedOnFromBelowAndWhatToHold)
{
    // A beam on a brick, and a brick below its free end.
    const auto bricks =
        BrickModel::createOfParts(test::createPartGrid({4, 1, 2}, 1.2), {{{0, 0, 0}, {1, 1, 1}, test::RED, 4},
                                                                         {{3, 0, 0}, {1, 1, 1}, test::RED, 4},
                                                                         {{0, 0, 1}, {4, 1, 1}, test::RED, 4}});
    std::vector<BuildingStep> steps{test::createStep({0}), test::createStep({2}), test::createStep({1})};
    steps[2].stands = false;
    const BookletModel model(*bricks, *BuildingPlan::create(3, std::move(steps)), Palette::getKnownColors());
    const BookletChapter& chapter = model.getMainChapter();
    EXPECT_EQ(describeNotes(model, chapter, chapter.steps[1]), "");
    EXPECT_EQ(
        describeNotes(model, chapter, chapter.steps[2]),
        "Press 1 red brick 1 x 1 on from below. Hold the model after this step: it does not stand by itself yet.");
}

TEST(BookletTextTest, NotesPartsThatHangFromOthersOfTheirStep)
{
    // A brick with a beam on it, and a brick below its free end, which is above the table: in one step, and in two.
    const auto bricks =
        BrickModel::createOfParts(test::createPartGrid({4, 1, 3}, 1.2), {{{0, 0, 0}, {1, 1, 1}, test::RED, 4},
                                                                         {{0, 0, 1}, {1, 1, 1}, test::RED, 4},
                                                                         {{3, 0, 1}, {1, 1, 1}, test::RED, 4},
                                                                         {{0, 0, 2}, {4, 1, 1}, test::RED, 4}});
    const auto createNotes = [&bricks](const std::vector<BuildingStep>& steps)
    {
        const BookletModel model(*bricks, *BuildingPlan::create(4, steps), Palette::getKnownColors());
        std::vector<std::string> notes;
        for (const BookletStep& step : model.getMainChapter().steps)
            notes.push_back(describeNotes(model, model.getMainChapter(), step));
        return notes;
    };
    const auto find = [&bricks](int x, int z) {
        return static_cast<std::uint32_t>(bricks->findPart({x, 0, z}) - bricks->getParts().data());
    };
    using Notes = std::vector<std::string>;
    EXPECT_EQ(createNotes({test::createStep({find(0, 0), find(0, 1), find(0, 2), find(3, 1)})}),
              Notes{"Join 1 red brick 1 x 1 with the new parts above before you place them."});
    EXPECT_EQ(createNotes({test::createStep({find(0, 0), find(0, 1), find(0, 2)}), test::createStep({find(3, 1)})}),
              (Notes{"", "Press 1 red brick 1 x 1 on from below."}));
}

TEST(BookletTextTest, NotesPiecesThatLieApartForSeveralSteps)
{
    // Three bricks side by side, one on the first, and beams that join the first two, and all.
    const std::vector<Part> parts{{{0, 0, 0}, {1, 1, 1}, test::RED, 4}, {{3, 0, 0}, {1, 1, 1}, test::RED, 4},
                                  {{6, 0, 0}, {1, 1, 1}, test::RED, 4}, {{0, 0, 1}, {4, 1, 1}, test::RED, 4},
                                  {{0, 0, 2}, {1, 1, 1}, test::RED, 4}, {{6, 0, 1}, {1, 1, 1}, test::RED, 4},
                                  {{3, 0, 2}, {4, 1, 1}, test::RED, 4}};
    const auto bricks = BrickModel::createOfParts(test::createPartGrid({8, 1, 3}, 1.2), parts);
    const auto find = [&bricks](int x, int z) {
        return static_cast<std::uint32_t>(bricks->findPart({x, 0, z}) - bricks->getParts().data());
    };
    const auto createNotes = [&](const std::vector<BuildingStep>& steps, BuildingBase base)
    {
        const BookletModel model(*bricks, *BuildingPlan::create(parts.size(), steps), Palette::getKnownColors(), base);
        std::vector<std::string> notes;
        for (const BookletStep& step : model.getMainChapter().steps)
            notes.push_back(describeNotes(model, model.getMainChapter(), step));
        return notes;
    };
    using Notes = std::vector<std::string>;
    const std::string apart =
        "Pieces lie apart until step 4: place them by the squares on the table, each a stud wide.";
    const std::vector<BuildingStep> steps{test::createStep({find(0, 0)}),
                                          test::createStep({find(3, 0), find(6, 0), find(6, 1)}),
                                          test::createStep({find(0, 1), find(0, 2)}), test::createStep({find(3, 2)})};
    EXPECT_EQ(createNotes(steps, BuildingBase::TABLE), (Notes{"", apart, "", ""}));
    EXPECT_EQ(createNotes(steps, BuildingBase::PLATE), Notes(4)) << "its studs show the places";
    const std::vector<BuildingStep> fast{test::createStep({find(0, 0), find(3, 0), find(6, 0), find(6, 1)}),
                                         test::createStep({find(0, 1), find(0, 2), find(3, 2)})};
    EXPECT_EQ(createNotes(fast, BuildingBase::TABLE), Notes(2)) << "the next step joins them";
}

TEST(BookletTextTest, PiecesThatNothingJoinsLieApart)
{
    const std::vector<Part> parts{{{0, 0, 0}, {1, 1, 1}, test::RED, 4}, {{3, 0, 0}, {1, 1, 1}, test::RED, 4}};
    const auto bricks = BrickModel::createOfParts(test::createPartGrid({4, 1, 1}, 1.2), parts);
    const auto plan = BuildingPlan::create(2, {test::createStep({0, 1})});
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    const BookletChapter& chapter = model.getMainChapter();
    EXPECT_EQ(describeNotes(model, chapter, chapter.steps[0]),
              "Pieces lie apart: place them by the squares on the table, each a stud wide.");
}

TEST(BookletTextTest, PartsInTheAirAreNoPiecesOnTheTable)
{
    const std::vector<Part> parts{{{0, 0, 0}, {1, 1, 1}, test::RED, 4}, {{3, 0, 2}, {1, 1, 1}, test::RED, 4}};
    const auto bricks = BrickModel::createOfParts(test::createPartGrid({4, 1, 3}, 1.2), parts);
    const auto plan = BuildingPlan::create(2, {test::createStep({0}), test::createStep({1})}, {}, {1});
    for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
    {
        const BookletModel model(*bricks, *plan, Palette::getKnownColors(), base);
        const BookletChapter& chapter = model.getMainChapter();
        EXPECT_EQ(describeNotes(model, chapter, chapter.steps[0]), "");
        EXPECT_EQ(describeNotes(model, chapter, chapter.steps[1]), "Nothing holds 1 part of this step.");
        EXPECT_EQ(chapter.steps[1].numPieces, 1u);
    }
}

TEST(BookletTextTest, ABoxOfAFewPartsNeedsNoHold)
{
    const BookletModel model = test::createTwins(true);
    BookletStep step;
    step.stands = false;
    EXPECT_EQ(describeHold(model.getChapters()[1], step), "") << "two parts";
    EXPECT_NE(describeHold(model.getChapters()[3], step), "") << "five parts";
}

TEST(BookletTextTest, NamesColorsAsBrickLinkDoes)
{
    PaletteColor color;
    color.name = "Light_Bluish_Grey";
    EXPECT_EQ(nameBrickLinkColor(color), "");
    color.brickLink = 86;
    EXPECT_EQ(nameBrickLinkColor(color), "Light Bluish Gray");
    EXPECT_EQ(nameColor(color), "Light Bluish Grey");
    color.name = "Medium_Lilac";
    color.brickLink = 89;
    EXPECT_EQ(nameBrickLinkColor(color), "Dark Purple");
}

} // namespace osgLego
