#include "BookletModels.h"
#include "StepPicture.h"

#include <booklet/BookletCamera.h>
#include <booklet/HiddenParts.h>

#include <PartModels.h>

#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

TEST_F(BookletPicturesTest, StepsShowOnlyThePartsInPlaceAtTheSamePlaceInEachPicture)
{
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 0}, {4, 2, 1}, BLUE, 1}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
    const auto plan = BuildingPlan::create(2, {createStep({0}), createStep({1})});
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    BookletPictures pictures(model, _renderer);
    for (const std::size_t step : {0, 1})
    {
        const Pixels pixels(pictures.drawStep(0, step));
        const StepPicture place({0, false}, parts, step + 1, {pixels.getWidth(), pixels.getHeight()});
        EXPECT_TRUE(pixels.getColor(place.find({2, 0, 0.5})).isRed());
        const Color second = pixels.getColor(place.find({6, 0, 0.5}));
        if (step == 0)
            EXPECT_LT(second.getSaturation(), 0.02) << "white";
        else
            EXPECT_GT(second.blue, second.red + 0.2);
    }
}

TEST_F(BookletPicturesTest, TheTableHasSquaresWhilePiecesLieApart)
{
    // Two bricks, and one that joins them.
    const std::vector<Part> parts{
        {{0, 0, 0}, {2, 2, 1}, RED, 4}, {{6, 0, 0}, {2, 2, 1}, RED, 4}, {{0, 0, 1}, {8, 2, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 2}, HEIGHT_OF_BRICK), parts);
    const auto plan = BuildingPlan::create(3, {createStep({0, 1}), createStep({2})});
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    BookletPictures pictures(model, _renderer);
    constexpr double WHITE = 0.99;
    for (const std::size_t step : {0, 1})
    {
        const Pixels pixels(pictures.drawStep(0, step));
        const StepPicture place({0, false}, parts, step + 2, {pixels.getWidth(), pixels.getHeight()});
        const Color corner = pixels.getColor(place.find({4, 0, 0}));
        EXPECT_EQ(corner.green < WHITE, step == 0) << corner.green;
        EXPECT_LT(corner.getSaturation(), 0.02) << "gray";
        if (step > 0) continue;
        EXPECT_GT(pixels.getColor(place.find({4.5, 0.5, 0}), 1).green, WHITE) << "in a square";
    }
}

TEST_F(BookletPicturesTest, StepsAreShownFromTheDirectionThatTheirTurnsSay)
{
    // A row of a red and a blue brick: the red end is on the left from the front and the right, and on the right
    // otherwise.
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 0}, {4, 2, 1}, BLUE, 1}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
    // The middle of a side that is visible: the front, the right, the back and the left.
    const std::array<std::array<glm::dvec3, 2>, 4> sides{{{{{2, 0, 0.5}, {6, 0, 0.5}}},
                                                          {{{2, 2, 0.5}, {6, 2, 0.5}}},
                                                          {{{2, 2, 0.5}, {6, 2, 0.5}}},
                                                          {{{2, 0, 0.5}, {6, 0, 0.5}}}}};
    for (int turns = 0; turns < 4; ++turns)
    {
        BuildingStep step = createStep({0, 1});
        step.turns = turns;
        const auto plan = BuildingPlan::create(2, {step});
        const BookletModel model(*bricks, *plan, Palette::getKnownColors());
        BookletPictures pictures(model, _renderer);
        const Pixels pixels(pictures.drawStep(0, 0));
        const StepPicture place({turns, false}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        const auto& [red, blue] = sides[static_cast<std::size_t>(turns)];
        EXPECT_TRUE(pixels.getColor(place.find(red)).isRed()) << turns;
        const Color color = pixels.getColor(place.find(blue));
        EXPECT_GT(color.blue, color.red + 0.2) << turns;
    }
}

TEST_F(BookletPicturesTest, StepsFromBelowShowTheModelUpsideDown)
{
    // A blue brick on a red one; both in a submodel that hangs from a beam on a column.
    const std::vector<Part> parts{{{4, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 1}, {4, 2, 1}, BLUE, 1}};
    std::vector<Part> all = parts;
    all.push_back({{0, 0, 0}, {2, 2, 1}, RED, 4});
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 2}, HEIGHT_OF_BRICK), all);
    const auto indexOf = [&bricks](const glm::ivec3& cell)
    { return static_cast<std::uint32_t>(bricks->findPart(cell) - bricks->getParts().data()); };
    for (const bool isUpsideDown : {false, true})
    {
        BuildingStep step = createStep({indexOf({4, 0, 0}), indexOf({4, 0, 1})});
        step.isFromBelow = isUpsideDown;
        const auto plan = BuildingPlan::create(3, {createStep({indexOf({0, 0, 0})}, {0})}, {{{step}}});
        const BookletModel model(*bricks, *plan, Palette::getKnownColors());
        BookletPictures pictures(model, _renderer);
        const Pixels pixels(pictures.drawStep(1, 0));
        const StepPicture place({0, isUpsideDown}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        const glm::dvec2 red = place.find({6, 0, 0.5});
        const glm::dvec2 blue = place.find({6, 0, 1.5});
        EXPECT_EQ(red.y < blue.y, isUpsideDown);
        EXPECT_TRUE(pixels.getColor(red).isRed()) << isUpsideDown;
        const Color color = pixels.getColor(blue);
        EXPECT_GT(color.blue, color.red + 0.2) << isUpsideDown;
    }
}

TEST_F(BookletPicturesTest, ArrowsLeadFromAboveToTheTopOfSubmodels)
{
    // A base, and a submodel of one brick on its right end.
    const std::vector<Part> parts{{{0, 0, 0}, {8, 2, 1}, RED, 4}, {{4, 0, 1}, {4, 2, 1}, BLUE, 1}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 2}, HEIGHT_OF_BRICK), parts);
    const auto plan = BuildingPlan::create(2, {createStep({0}, {0})}, {{{createStep({1})}}});
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    BookletPictures pictures(model, _renderer);
    const BookletPicture picture = pictures.drawStep(0, 0);
    ASSERT_EQ(picture.arrows.size(), 1u);
    const BookletArrow& arrow = picture.arrows[0];
    const StepPicture place({0, false}, parts, 2, {picture.width, picture.height});
    // The highest corner is the one behind at the left; the middle is that of the front right and the back left corner.
    const glm::dvec2 top = place.find({4, 2, 2});
    const double middle = 0.5 * (place.find({4, 0, 2}).x + place.find({8, 2, 2}).x);
    EXPECT_NEAR(arrow.tip.x, middle, 1.0);
    EXPECT_NEAR(arrow.tail.x, middle, 1.0);
    EXPECT_LT(arrow.tip.y, top.y) << "the arrow ends above the submodel";
    EXPECT_GT(arrow.tip.y, top.y - place.getScale()) << "less than a pitch above its studs";
    EXPECT_LT(arrow.tail.y, arrow.tip.y - place.getScale()) << "it points downwards";
    EXPECT_GT(arrow.tail.y, 0.0) << "all of it is in the picture";
    EXPECT_TRUE(BookletPictures(model, _renderer).drawStep(1, 0).arrows.empty());
}

TEST_F(BookletPicturesTest, FinishedSubmodelsReplaceAStepThatShowsNoMore)
{
    // A submodel of a post below a roof, which hides the post more the farther it is from the eye.
    constexpr double LEAST_SHARE = 0.25;
    int numAlike = 0;
    for (const std::uint16_t y : {std::uint16_t(1), std::uint16_t(3)})
        for (const int turns : {0, 1})
        {
            const std::vector<Part> parts{
                {{0, 0, 0}, {4, 2, 1}, RED, 4}, {{0, y, 1}, {1, 1, 1}, BLUE, 1}, {{0, 0, 2}, {4, 4, 1}, BLUE, 1}};
            const auto bricks = BrickModel::createOfParts(createPartGrid({4, 4, 3}, HEIGHT_OF_BRICK), parts);
            BuildingStep inner = createStep({1, 2});
            inner.turns = turns;
            const auto plan = BuildingPlan::create(3, {createStep({0}, {0})}, {{{inner}}});
            const BookletModel model(*bricks, *plan, Palette::getKnownColors());
            BookletPictures pictures(model, _renderer);
            const BookletChapter& submodel = model.getChapters()[1];
            const auto& order = submodel.plan->getOrder();
            const glm::dvec3 toEye = BookletCamera(submodel.model->getGrid(), {0, false}).getToEye();
            const bool showsAll = findHiddenParts(*submodel.model, order, order, toEye, LEAST_SHARE).empty();
            const bool isAlike = turns == 0 && pictures.drawStep(1, 0).arrows.empty();
            EXPECT_EQ(pictures.replacesSteps(1), showsAll || isAlike) << y << ", " << turns;
            numAlike += isAlike && !showsAll ? 1 : 0;
        }
    EXPECT_GT(numAlike, 0);
}

TEST_F(BookletPicturesTest, ArrowsAndTheirLettersAreApart)
{
    // Three submodels of one brick each, one behind the other: their middles are near each other in the picture.
    std::vector<Part> parts{{{0, 0, 0}, {8, 8, 1}, RED, 4}};
    std::vector<Submodel> submodels;
    for (std::uint16_t place = 0; place < 3; ++place)
    {
        const auto x = static_cast<std::uint16_t>(2 * place);
        const auto y = static_cast<std::uint16_t>(6 - 3 * place);
        parts.push_back({{x, y, 1}, {2, 2, 1}, BLUE, 1});
        submodels.push_back({{createStep({place + 1u})}});
    }
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 8, 2}, HEIGHT_OF_BRICK), parts);
    const auto plan = BuildingPlan::create(4, {createStep({0}, {0, 1, 2})}, submodels);
    const BookletModel model(*bricks, *plan, Palette::getKnownColors());
    const BookletPicture picture = BookletPictures(model, _renderer).drawStep(0, 0);
    ASSERT_EQ(picture.arrows.size(), 3u);
    std::vector<double> tails;
    for (const BookletArrow& arrow : picture.arrows)
        tails.push_back(arrow.tail.x);
    std::sort(tails.begin(), tails.end());
    const double width = picture.arrows[0].width;
    // A letter is as wide as three shafts at most, and so is the head of an arrow.
    for (const std::size_t tail : {1, 2})
        EXPECT_GT(tails[tail] - tails[tail - 1], 3.0 * width);
    for (const BookletArrow& arrow : picture.arrows)
    {
        EXPECT_LT(arrow.letter.y, arrow.tail.y) << "above the arrow";
        EXPECT_GT(arrow.letter.y - 2.25 * width, 0.0) << "a capital letter is three quarters of its font high";
        EXPECT_GT(arrow.letter.x - 1.5 * width, 0.0);
        EXPECT_LT(arrow.letter.x + 1.5 * width, picture.width);
    }
}

TEST_F(BookletPicturesTest, StepsOfAChapterAreAsWideAsItsWidestView)
{
    // From the front, a long brick is wider than from the side; the widest view comes first or last.
    const std::vector<Part> parts{{{0, 0, 0}, {8, 2, 1}, RED, 4}, {{0, 0, 1}, {8, 2, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 2}, HEIGHT_OF_BRICK), parts);
    const Projection front(0, false);
    const double widest = front.project({8, 2, 0}).x - front.project({0, 0, 0}).x;
    const double width = 90.0 * (widest + 2.0 * MARGIN); // the largest scale of steps, in pixels a stud
    for (const int first : {0, 1})
    {
        std::vector<BuildingStep> steps{createStep({0}), createStep({1})};
        steps[0].turns = first;
        steps[1].turns = 1 - first;
        const BookletModel model(*bricks, *BuildingPlan::create(2, steps), Palette::getKnownColors());
        BookletPictures pictures(model, _renderer);
        for (const std::size_t step : {0, 1})
            EXPECT_NEAR(pictures.drawStep(0, step).width, width, 1.0) << first;
    }
}

namespace
{

/** A tower of 24 bricks, one on another in a step each: blue ones on red ones. */
BookletModel createTallTower()
{
    constexpr std::uint32_t NUM_BRICKS = 24;
    std::vector<Part> parts;
    std::vector<BuildingStep> steps;
    for (std::uint32_t part = 0; part < NUM_BRICKS; ++part)
    {
        const bool isRed = part < NUM_BRICKS / 2;
        parts.push_back({{0, 0, static_cast<std::uint16_t>(part)}, {2, 2, 1}, isRed ? RED : BLUE, isRed ? 4 : 1});
        steps.push_back(createStep({part}));
    }
    const auto bricks = BrickModel::createOfParts(createPartGrid({2, 2, NUM_BRICKS}, HEIGHT_OF_BRICK), parts);
    return {*bricks, *BuildingPlan::create(NUM_BRICKS, steps), Palette::getKnownColors()};
}

std::vector<BookletBlock> createLastBlocks(std::size_t number)
{
    std::vector<BookletBlock> blocks(number);
    for (std::size_t block = 0; block < number; ++block)
        blocks[block].step = 24 - number + block;
    return blocks;
}

} // namespace

TEST_F(BookletPicturesTest, PicturesOfASectionFadeAwayBelow)
{
    const BookletModel model = createTallTower();
    BookletPictures pictures(model, _renderer);
    pictures.setSection(0, createLastBlocks(4));
    const Pixels pixels(pictures.drawStep(0, 23));
    const double middle = 0.5 * pixels.getWidth();
    EXPECT_GT(pixels.getColor({middle, pixels.getHeight() - 3.0}).green, 0.9) << "white at the lower edge";
    const Color above = pixels.getColor({middle, 0.7 * pixels.getHeight()});
    EXPECT_LT(above.green, 0.8) << "the model, faded as in all steps";
}

TEST_F(BookletPicturesTest, PlacesShowTheWholeModelAndThePartsOfASectionInFullColours)
{
    const BookletModel model = createTallTower();
    BookletPictures pictures(model, _renderer);
    const auto saturationsOf = [&](std::size_t number)
    {
        const Pixels pixels(pictures.drawPlace(0, createLastBlocks(number)));
        const double middle = 0.45 * pixels.getWidth();
        return std::pair(pixels.getColor({middle, 0.15 * pixels.getHeight()}).getSaturation(),
                         pixels.getColor({middle, 0.85 * pixels.getHeight()}).getSaturation());
    };
    const auto [blue, fadedRed] = saturationsOf(12);
    const auto [all, red] = saturationsOf(24);
    EXPECT_NEAR(blue, all, 0.05);
    EXPECT_LT(fadedRed, 0.6 * red);
    EXPECT_GT(fadedRed, 0.01) << "but it is there";
}

TEST_F(BookletPicturesTest, KindsLieWithTheirLongSideToTheRight)
{
    const std::vector<Part> parts{{{0, 0, 0}, {2, 8, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({2, 8, 1}, HEIGHT_OF_BRICK), parts);
    const BookletModel model(*bricks, *BuildingPlan::create(1, {createStep({0})}), Palette::getKnownColors());
    const BookletPicture picture = BookletPictures(model, _renderer).drawKind(0);
    const Projection projection(0, false);
    const double width = projection.project({8, 2, 0}).x - projection.project({0, 0, 0}).x + 2.0 * MARGIN;
    EXPECT_NEAR(picture.width, 40.0 * width, 1.0) << "20 pixels of CSS a stud, at twice the density";
}

} // namespace osgLego::test
