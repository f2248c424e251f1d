#include "BookletModels.h"

#include <booklet/BookletModel.h>

#include <PartModels.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

using test::BLUE;
using test::createStep;
using test::RED;

Part createPart(const glm::ivec3& cell, const glm::ivec3& size, const std::array<std::uint8_t, 3>& color,
                std::int32_t code)
{
    Part part;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        part.cell[axis] = static_cast<std::uint16_t>(cell[static_cast<int>(axis)]);
        part.size[axis] = static_cast<std::uint8_t>(size[static_cast<int>(axis)]);
    }
    part.color = color;
    part.colorCode = code;
    return part;
}

/** Four bricks 2x4 and one 1x1: 0 and 1 below, 2 across both, 3 and 4 upon it. */
osg::ref_ptr<const BrickModel> createModel()
{
    return BrickModel::createOfParts(test::createPartGrid({8, 4, 3}, 1.2), {createPart({0, 0, 0}, {2, 4, 1}, RED, 4),
                                                                            createPart({4, 0, 0}, {2, 4, 1}, RED, 4),
                                                                            createPart({1, 0, 1}, {4, 2, 1}, BLUE, 1),
                                                                            createPart({1, 0, 2}, {4, 2, 1}, RED, 4),
                                                                            createPart({5, 1, 2}, {1, 1, 1}, RED, 4)});
}

/** Parts 0 and 1; then submodel 0, which attaches submodel 1 to part 2; then part 4. */
osg::ref_ptr<const BuildingPlan> createPlan()
{
    Submodel outer;
    outer.steps = {createStep({2}), createStep({}, {1})};
    Submodel inner;
    inner.steps = {createStep({3})};
    std::vector<BuildingStep> steps{createStep({0, 1}), createStep({}, {0}), createStep({4})};
    steps[2].turns = 2;
    return BuildingPlan::create(5, std::move(steps), {outer, inner});
}

} // namespace

class BookletModelTest : public testing::Test
{
protected:
    osg::ref_ptr<const BrickModel> _bricks = createModel();
    osg::ref_ptr<const BuildingPlan> _plan = createPlan();
    BookletModel _model{*_bricks, *_plan, Palette::getKnownColors()};
};

TEST_F(BookletModelTest, CountsTheKindsOfEachStep)
{
    ASSERT_EQ(_model.getKinds().size(), 3u);
    const std::vector<BookletStep>& steps = _model.getMainChapter().steps;
    ASSERT_EQ(steps.size(), 3u);
    ASSERT_EQ(steps[0].items.size(), 1u);
    EXPECT_EQ(steps[0].items[0].quantity, 2u);
    EXPECT_EQ(_model.getKinds()[steps[0].items[0].kind].type->number, "3001");
    EXPECT_EQ(_model.getKinds()[steps[0].items[0].kind].color.name, "Red");
    EXPECT_TRUE(steps[1].items.empty());
    EXPECT_EQ(steps[1].numNew, 2u);
    EXPECT_EQ(steps[1].numPlaced, 4u);
}

TEST_F(BookletModelTest, ListsThePartsOfSubmodelsWithinSubmodels)
{
    const BookletChapter& outer = _model.getChapters()[1];
    EXPECT_EQ(outer.model->getParts().size(), 2u);
    EXPECT_EQ(outer.plan->getNumPlaced(0), 1u);
    EXPECT_EQ(outer.plan->getNumPlaced(1), 2u);
    // The blue brick is placed first, and only the red one of its model last.
    EXPECT_EQ(outer.model->getParts()[outer.plan->getOrder()[0]].color, BLUE);
    std::size_t quantity = 0;
    for (const BookletItem& item : outer.items)
        quantity += item.quantity;
    EXPECT_EQ(quantity, 2u);
}

TEST_F(BookletModelTest, NamesStepsAndSubmodelsInTheOrderOfBuilding)
{
    EXPECT_EQ(_model.getChapters()[1].letter, "A");
    EXPECT_EQ(_model.getChapters()[2].letter, "B");
    EXPECT_EQ(_model.getMainChapter().steps[2].name, "3");
    EXPECT_EQ(_model.getChapters()[1].steps[1].name, "A2");
}

TEST_F(BookletModelTest, SubmodelsOfAStepAreCopiesIfTheirPartsAreEqual)
{
    // Bricks of 2x4 on a row: three along x, of which the last is blue, one along y, and one along x in another step.
    std::vector<Part> parts;
    for (const int x : {0, 4, 8})
        parts.push_back(createPart({x, 0, 0}, {4, 2, 1}, x == 8 ? BLUE : RED, x == 8 ? 1 : 4));
    parts.push_back(createPart({12, 0, 0}, {2, 4, 1}, RED, 4));
    parts.push_back(createPart({14, 0, 0}, {4, 2, 1}, RED, 4));
    std::vector<Submodel> submodels;
    for (std::uint32_t index = 0; index < 5; ++index)
        submodels.push_back({{createStep({index})}});
    const auto bricks = BrickModel::createOfParts(test::createPartGrid({18, 4, 1}, 1.2), parts);
    const auto plan = BuildingPlan::create(5, {createStep({}, {0, 1, 2, 3}), createStep({}, {4})}, submodels);
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    const std::vector<BookletChapter>& chapters = model.getChapters();
    EXPECT_EQ(model.getOriginals(model.getMainChapter().steps[0]), (std::vector<std::size_t>{1, 3}));
    EXPECT_EQ(chapters[1].quantity, 3u);
    EXPECT_EQ(chapters[2].original, 1u);
    EXPECT_EQ(chapters[2].copy, 2u);
    EXPECT_EQ(chapters[2].letter, "A");
    EXPECT_EQ(chapters[2].turn.turns, 0);
    EXPECT_EQ(chapters[3].letter, "B");
    EXPECT_EQ(chapters[4].original, 1u) << "turned";
    EXPECT_EQ(chapters[4].turn.turns, 1);
    EXPECT_EQ(chapters[5].letter, "C") << "another step";
}

TEST_F(BookletModelTest, AnArrowToASubmodelHasItsLetterIfArrowsMayPointToOtherParts)
{
    const auto bricks =
        BrickModel::createOfParts(test::createPartGrid({4, 2, 2}, 1.2), {{{0, 0, 0}, {4, 2, 1}, {180, 0, 0}, 4},
                                                                         {{0, 0, 1}, {2, 2, 1}, {180, 0, 0}, 4},
                                                                         {{2, 0, 1}, {2, 2, 1}, {180, 0, 0}, 4}});
    for (const bool isAlone : {false, true})
    {
        std::vector<BuildingStep> steps{createStep({0}), createStep({2}, {0})};
        if (isAlone) steps = {createStep({0, 2}), createStep({}, {0})};
        const auto plan = BuildingPlan::create(3, steps, {{{createStep({1})}}});
        const BookletModel model(*bricks, *plan, Palette::getKnownColors());
        EXPECT_EQ(model.getMainChapter().steps[1].hasLetters(), !isAlone);
        EXPECT_FALSE(model.getMainChapter().steps[0].hasLetters());
    }
}

TEST_F(BookletModelTest, NamesSubmodelsAfterZWithTwoLetters)
{
    // A submodel for each brick of a row.
    constexpr std::uint32_t COUNT = 26 + 26 * 26 + 1;
    std::vector<Part> parts;
    std::vector<Submodel> submodels;
    std::vector<BuildingStep> steps;
    for (std::uint32_t index = 0; index < COUNT; ++index)
    {
        parts.push_back(createPart({static_cast<int>(index), 0, 0}, {1, 1, 1}, RED, 4));
        submodels.push_back({{createStep({index})}});
        steps.push_back(createStep({}, {index}));
    }
    const auto bricks =
        BrickModel::createOfParts(test::createPartGrid({static_cast<int>(COUNT), 1, 1}, 1.2), std::move(parts));
    const BookletModel model(*bricks, *BuildingPlan::create(COUNT, std::move(steps), std::move(submodels)), {});
    const auto letterOf = [&model](std::size_t submodel) { return model.getChapters()[submodel + 1].letter; };
    EXPECT_EQ(letterOf(0), "A");
    EXPECT_EQ(letterOf(8), "J") << "I looks like a digit";
    EXPECT_EQ(letterOf(13), "P");
    EXPECT_EQ(letterOf(23), "Z");
    EXPECT_EQ(letterOf(24), "AA");
    EXPECT_EQ(letterOf(25), "AB");
    EXPECT_EQ(letterOf(24 + 23), "AZ");
    EXPECT_EQ(letterOf(24 + 24), "BA");
    EXPECT_EQ(letterOf(24 + 24 * 24 - 1), "ZZ");
    EXPECT_EQ(letterOf(24 + 24 * 24), "AAA");
    EXPECT_EQ(model.getChapters()[25].steps[0].name, "AA1");
}

TEST_F(BookletModelTest, MarksStepsWhoseViewChanges)
{
    const std::vector<BookletStep>& steps = _model.getMainChapter().steps;
    EXPECT_FALSE(steps[0].isTurned);
    EXPECT_FALSE(steps[1].isTurned);
    EXPECT_TRUE(steps[2].isTurned);
}

TEST(BookletModel, MarksFirstStepsThatDoNotShowTheFront)
{
    const auto create = [](int turns, bool isFromBelow)
    {
        const auto bricks =
            BrickModel::createOfParts(test::createPartGrid({1, 1, 2}, 1.2), {Part{{0, 0, 0}}, Part{{0, 0, 1}}});
        Submodel submodel{{createStep({1})}};
        submodel.steps[0].turns = turns;
        submodel.steps[0].isFromBelow = isFromBelow;
        const auto plan = BuildingPlan::create(2, {createStep({0}), createStep({}, {0})}, {submodel});
        return BookletModel(*bricks, *plan, {}).getChapters()[1].steps[0];
    };
    EXPECT_FALSE(create(0, false).isTurned);
    EXPECT_TRUE(create(2, false).isTurned);
    EXPECT_FALSE(create(2, false).isTurnedOver);
    EXPECT_TRUE(create(0, true).isTurned);
    EXPECT_TRUE(create(0, true).isTurnedOver);
}

TEST(BookletModel, FindsPartsThatArePressedOnFromBelow)
{
    // A beam on a column of two bricks, with a brick below its free end, and one on top of that end.
    const auto bricks =
        BrickModel::createOfParts(test::createPartGrid({4, 1, 4}, 1.2),
                                  {createPart({0, 0, 0}, {1, 1, 1}, RED, 4), createPart({0, 0, 1}, {1, 1, 1}, RED, 4),
                                   createPart({3, 0, 1}, {1, 1, 1}, RED, 4), createPart({0, 0, 2}, {4, 1, 1}, RED, 4),
                                   createPart({3, 0, 3}, {1, 1, 1}, RED, 4)});
    const auto quantitiesOf = [](const std::vector<BookletStep>& steps)
    {
        std::vector<std::size_t> quantities;
        for (const BookletStep& step : steps)
            quantities.push_back(step.pressed.empty() ? 0 : step.pressed.front().quantity);
        return quantities;
    };
    const auto upright =
        BuildingPlan::create(5, {createStep({0}), createStep({1}), createStep({3}), createStep({2}), createStep({4})});
    EXPECT_EQ(quantitiesOf(BookletModel(*bricks, *upright, {}).getMainChapter().steps),
              (std::vector<std::size_t>{0, 0, 0, 1, 0}));
    // A beam and the brick below it that are placed in one step are joined in a hand.
    const auto joined =
        BuildingPlan::create(5, {createStep({0}), createStep({1}), createStep({3, 2}), createStep({4})});
    EXPECT_EQ(quantitiesOf(BookletModel(*bricks, *joined, {}).getMainChapter().steps),
              (std::vector<std::size_t>{0, 0, 0, 0}));
    Submodel over{{createStep({3}), createStep({2}), createStep({4})}};
    for (BuildingStep& step : over.steps)
        step.isFromBelow = true;
    const auto plan = BuildingPlan::create(5, {createStep({0, 1}), createStep({}, {0})}, {over});
    EXPECT_EQ(quantitiesOf(BookletModel(*bricks, *plan, {}).getChapters()[1].steps),
              (std::vector<std::size_t>{0, 0, 1}));
}

TEST(BookletModel, ABasePlateJoinsThePiecesThatStandOnIt)
{
    // Two bricks on the base, one on one of them, and one in the air.
    const auto model = BrickModel::createOfParts(test::createPartGrid({9, 1, 3}, 1.2),
                                                 {Part{{0, 0, 0}}, Part{{4, 0, 0}}, Part{{4, 0, 1}}, Part{{8, 0, 2}}});
    const auto plan = BuildingPlan::create(4, {createStep({0, 1}), createStep({2}), createStep({3})}, {}, {3});
    EXPECT_EQ(BookletModel(*model, *plan, {}, BuildingBase::TABLE).getNumPieces(), 3u);
    EXPECT_EQ(BookletModel(*model, *plan, {}, BuildingBase::PLATE).getNumPieces(), 2u);
}

TEST_F(BookletModelTest, MeasuresTheModelInMillimetres)
{
    EXPECT_EQ(_model.getNumParts(), 5u);
    EXPECT_EQ(_model.getNumPieces(), 2u); // nothing is below the smallest brick
    EXPECT_DOUBLE_EQ(_model.getSize().x, 48.0);
    EXPECT_DOUBLE_EQ(_model.getSize().y, 32.0);
    EXPECT_NEAR(_model.getSize().z, 28.8, 1e-9);
    EXPECT_NEAR(_model.getMass(), 4 * 2.16 + 0.43, 1e-9);
}

TEST_F(BookletModelTest, MeasuresModelsOfPlatesWithYUpwards)
{
    // Three studs to the right, two to the back, and four plates high: z points to the front.
    const auto bricks =
        BrickModel::createOfParts(test::createPartGrid({8, 9, 8}, 0.4, UpAxis::Y),
                                  {createPart({1, 2, 1}, {3, 3, 2}, RED, 4), createPart({1, 5, 1}, {3, 1, 2}, RED, 4)});
    const BookletModel model(*bricks, *BuildingPlan::create(2, {createStep({0}), createStep({1})}), {});
    EXPECT_DOUBLE_EQ(model.getSize().x, 24.0);
    EXPECT_DOUBLE_EQ(model.getSize().y, 16.0);
    EXPECT_NEAR(model.getSize().z, 12.8, 1e-9);
}

TEST_F(BookletModelTest, NamesFallingStepsOfLargeSubmodelsButNotThoseOfUnheldParts)
{
    Submodel outer;
    outer.steps = {createStep({2}), createStep({}, {1})};
    outer.steps[0].stands = false;
    Submodel inner;
    inner.steps = {createStep({3})};
    std::vector<BuildingStep> steps{createStep({0}), createStep({1}), createStep({}, {0}), createStep({4})};
    steps[1].stands = false;
    steps[3].stands = false;
    const osg::ref_ptr<const BuildingPlan> plan = BuildingPlan::create(5, std::move(steps), {outer, inner}, {4});
    const BookletModel model(*_bricks, *plan, Palette::getKnownColors());
    EXPECT_EQ(model.getFallingSteps(), std::vector<std::string>{"2"}) << "a hand holds the submodels";
    EXPECT_EQ(test::createTwins(true).getFallingSteps(), std::vector<std::string>{"B2"});
    EXPECT_EQ(model.getNumUnheld(), 1u);
    const std::vector<BookletStep>& main = model.getMainChapter().steps;
    EXPECT_TRUE(main[1].falls());
    EXPECT_EQ(main[1].numUnheld, 0u);
    EXPECT_FALSE(main[3].falls());
    EXPECT_EQ(main[3].numUnheld, 1u);
    EXPECT_EQ(_model.getFallingSteps(), std::vector<std::string>());
}

} // namespace osgLego
