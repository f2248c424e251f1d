#include "BookletModels.h"
#include "StepPicture.h"

#include <booklet/NewPartOutline.h>

#include <PartModels.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

class BookletLookTest : public BookletPicturesTest
{
};

TEST_F(BookletLookTest, StepsHighlightTheirNewPartsAndFadeTheOthers)
{
    // Two red bricks side by side, which two steps place; the middle of the front of each is visible.
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 0}, {4, 2, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
    for (const bool isReversed : {false, true})
    {
        const auto plan =
            BuildingPlan::create(2, {createStep({isReversed ? 1u : 0u}), createStep({isReversed ? 0u : 1u})});
        const BookletModel model(*bricks, *plan, Palette::getKnownColors());
        BookletPictures pictures(model, _renderer);
        const Pixels pixels(pictures.drawStep(0, 1));
        const StepPicture place({0, false}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        const double left = pixels.getColor(place.find({2, 0, 0.5})).getSaturation();
        const double right = pixels.getColor(place.find({6, 0, 0.5})).getSaturation();
        EXPECT_GT(isReversed ? left : right, 0.8) << "the new part";
        EXPECT_LT(isReversed ? right : left, 0.6) << "the part of the step before";
        EXPECT_GT(isReversed ? right : left, 0.1) << "it keeps its colour";
    }
}

TEST_F(BookletLookTest, ColorsLookAlikeBeforeAndAfterATurn)
{
    // A turn shows other sides of a square brick at the same places of the picture; upside down, its bottom is on top.
    for (const std::array<std::uint8_t, 3> shown : {std::array<std::uint8_t, 3>{244, 244, 244}, {250, 200, 10}})
    {
        const std::vector<Part> parts{{{0, 0, 0}, {4, 4, 1}, shown, Part::NO_CODE}};
        const auto bricks = BrickModel::createOfParts(createPartGrid({4, 4, 1}, HEIGHT_OF_BRICK), parts);
        std::array<Color, 3> before;
        for (int turns = 0; turns < 4; ++turns)
        {
            BuildingStep step = createStep({0});
            step.turns = turns;
            const BookletModel model(*bricks, *BuildingPlan::create(1, {step}), {});
            const Pixels pixels(BookletPictures(model, _renderer).drawStep(0, 0));
            const StepPicture place({0, false}, parts, 1, {pixels.getWidth(), pixels.getHeight()});
            const std::array<glm::dvec3, 3> places{
                {{2, 0, 0.5}, {4, 2, 0.5}, {2, 2, 1}}}; // the left, the right, the top
            for (std::size_t side = 0; side < places.size(); ++side)
            {
                const Color color = pixels.getColor(place.find(places[side]));
                if (turns == 0) before[side] = color;
                EXPECT_NEAR(color.red, before[side].red, 0.02) << turns << " turns, side " << side;
                EXPECT_NEAR(color.green, before[side].green, 0.02) << turns << " turns, side " << side;
                EXPECT_NEAR(color.blue, before[side].blue, 0.02) << turns << " turns, side " << side;
            }
        }
    }
}

TEST_F(BookletLookTest, NewPartsHaveAnOutlineOfEnoughContrastOnModelsOfOneColor)
{
    // An old brick on the left, and a new one beside it; in white, grey, black, yellow, red, blue and tan.
    for (const std::array<std::uint8_t, 3> shown : {std::array<std::uint8_t, 3>{244, 244, 244},
                                                    {150, 150, 150},
                                                    {33, 33, 33},
                                                    {250, 200, 10},
                                                    RED,
                                                    BLUE,
                                                    {215, 186, 140}})
    {
        const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, shown}, {{4, 0, 0}, {4, 2, 1}, shown}};
        const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
        const auto plan = BuildingPlan::create(2, {createStep({0}), createStep({1})});
        const BookletModel model(*bricks, *plan, {});
        const Pixels pixels(BookletPictures(model, _renderer).drawStep(0, 1));
        const StepPicture place({0, false}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        const auto toPixel = [](const Color& color)
        {
            const auto toByte = [](double value) { return static_cast<std::uint8_t>(std::lround(255.0 * value)); };
            return PixelColor{toByte(color.red), toByte(color.green), toByte(color.blue)};
        };
        // The line is a few pixels wide, to the left of the seam on the front, and below the lower edge on the right.
        for (const auto& [edge, outwards] :
             {std::pair(glm::dvec3(4, 0, 0.5), glm::dvec2(-1, 0)), std::pair(glm::dvec3(6, 0, 0), glm::dvec2(0, 1))})
        {
            const PixelColor line = toPixel(pixels.getColor(place.find(edge) + 2.0 * outwards, 1));
            const PixelColor beside = toPixel(pixels.getColor(place.find(edge) + 20.0 * outwards));
            EXPECT_GE(getContrast(line, beside), NewPartOutline::LEAST_CONTRAST)
                << static_cast<int>(shown[0]) << " " << static_cast<int>(line[0]) << "," << static_cast<int>(line[1])
                << "," << static_cast<int>(line[2]) << " beside " << static_cast<int>(beside[0]);
        }
    }
}

TEST_F(BookletLookTest, SubmodelsThatAStepPlacesAndItsOtherPartsHaveOutlinesOfTheirOwnInTheSameColor)
{
    // Two white stacks of two bricks side by side on earlier bricks; the left one is a submodel, or both are. In a
    // longer row of earlier bricks, the picture is smaller.
    const std::array<std::uint8_t, 3> white{244, 244, 244};
    for (const auto& [numEarlier, areBothSubmodels] : {std::pair(1u, false), {8u, false}, {1u, true}})
    {
        std::vector<Part> parts;
        for (std::size_t part = 0; part < numEarlier; ++part)
            parts.push_back({{static_cast<std::uint16_t>(8 * part), 0, 0}, {8, 2, 1}, white});
        for (const std::uint16_t layer : std::vector<std::uint16_t>{1, 2})
            for (const std::uint16_t left : std::vector<std::uint16_t>{0, 4})
                parts.push_back({{left, 0, layer}, {4, 2, 1}, white});
        const auto bricks =
            BrickModel::createOfParts(createPartGrid({8 * static_cast<int>(numEarlier), 2, 3}, HEIGHT_OF_BRICK), parts);
        const auto find = [&](int x, int z) {
            return static_cast<std::uint32_t>(bricks->findPart({x, 0, z}) - bricks->getParts().data());
        };
        BuildingStep first;
        for (std::size_t part = 0; part < numEarlier; ++part)
            first.parts.push_back(find(8 * static_cast<int>(part), 0));
        const Submodel left{{createStep({find(0, 1), find(0, 2)})}};
        const BuildingStep right = createStep({find(4, 1), find(4, 2)});
        BuildingStep second = createStep({}, {0, 1});
        std::vector<Submodel> submodels{left, {{right}}};
        if (!areBothSubmodels)
        {
            second = createStep(right.parts, {0});
            submodels.pop_back();
        }
        const auto plan = BuildingPlan::create(parts.size(), {first, second}, submodels);
        const BookletModel model(*bricks, *plan, {});
        const Pixels pixels(BookletPictures(model, _renderer).drawStep(0, 1));
        const StepPicture place({0, false}, parts, parts.size(), {pixels.getWidth(), pixels.getHeight()});
        // The line between them is beside the black line of the parts at the seam: outside of the parts that the step
        // places, or of the first submodel. The one around both is to the left of this submodel.
        const double outwards = areBothSubmodels ? 1.0 : -1.0;
        const Color between =
            pixels.getColor(place.find({4, 0, 1.5}) + glm::dvec2(areBothSubmodels ? 2.0 : -3.0, 0.0), 0);
        const Color around = pixels.getColor(place.find({0, 0, 1.5}) - glm::dvec2(3.0, 0.0), 0);
        const Color beside = pixels.getColor(place.find({4, 0, 1.5}) + glm::dvec2(12.0 * outwards, 0.0), 0);
        EXPECT_GT(beside.green, 0.4) << numEarlier;
        EXPECT_LT(between.green, 0.5 * beside.green) << numEarlier;
        EXPECT_NEAR(between.red, around.red, 0.1) << numEarlier;
        EXPECT_NEAR(between.green, around.green, 0.1) << numEarlier;
        EXPECT_NEAR(between.blue, around.blue, 0.1) << numEarlier;
    }
}

TEST_F(BookletLookTest, TheFrontIsTheGivenViewForTheCoverAndForSteps)
{
    // A row of a red and a blue brick, seen from the back: the red end is on the right.
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}, {{4, 0, 0}, {4, 2, 1}, BLUE, 1}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({8, 2, 1}, HEIGHT_OF_BRICK), parts);
    const BookletModel model(*bricks, *BuildingPlan::create(2, {createStep({0, 1})}), Palette::getKnownColors());
    BookletPictures pictures(model, _renderer, {213.0, BuildingStep::ELEVATION});
    for (const BookletPicture& picture : {pictures.drawStep(0, 0), pictures.drawFinished(0)})
    {
        const Pixels pixels(picture);
        const StepPicture place({2, false}, parts, 2, {pixels.getWidth(), pixels.getHeight()});
        EXPECT_TRUE(pixels.getColor(place.find({2, 2, 0.5})).isRed());
        EXPECT_FALSE(pixels.getColor(place.find({6, 2, 0.5})).isRed());
    }
}

TEST_F(BookletLookTest, ModelsOnABasePlateAreShownOnIt)
{
    const std::vector<Part> parts{{{0, 0, 0}, {4, 4, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({4, 4, 1}, HEIGHT_OF_BRICK), parts);
    const BookletModel model(*bricks, *BuildingPlan::create(1, {createStep({0})}), Palette::getKnownColors(),
                             BuildingBase::PLATE);
    BookletPictures pictures(model, _renderer);
    // The plate has 16 x 8 studs.
    const Projection projection(0, false);
    const double width = projection.project({16, 8, 0}).x - projection.project({0, 0, 0}).x + 2.0 * MARGIN;
    for (const BookletPicture& picture : {pictures.drawStep(0, 0), pictures.drawFinished(0)})
    {
        const Pixels pixels(picture);
        const double scale = pixels.getWidth() / width;
        // From the middle of the front of the plate: its near corner is the lowest point, its right the rightmost one.
        const glm::dvec2 place = projection.project({5.5, 0.5, 0.0}) - projection.project({0, 0, -0.2});
        const glm::dvec2 lowest = projection.project({16, 0, 0}) - projection.project({0, 0, 0});
        const Color color =
            pixels.getColor({(place.x + MARGIN) * scale, pixels.getHeight() - (place.y - lowest.y + MARGIN) * scale});
        EXPECT_GT(color.green, color.red + 0.03);
        EXPECT_GT(color.green, color.blue);
    }
}

TEST_F(BookletLookTest, KindsAndFinishedModelsHaveTransparentBackgroundsAndFullColors)
{
    const std::vector<Part> parts{{{0, 0, 0}, {4, 2, 1}, RED, 4}};
    const auto bricks = BrickModel::createOfParts(createPartGrid({4, 2, 1}, HEIGHT_OF_BRICK), parts);
    const BookletModel model(*bricks, *BuildingPlan::create(1, {createStep({0})}), Palette::getKnownColors());
    BookletPictures pictures(model, _renderer);
    for (const BookletPicture& picture : {pictures.drawKind(0), pictures.drawFinished(0)})
    {
        EXPECT_NE(picture.mediaType, "image/jpeg");
        const Pixels pixels(picture);
        const StepPicture place({0, false}, parts, 1, {pixels.getWidth(), pixels.getHeight()});
        EXPECT_GT(pixels.getColor(place.find({2, 0, 0.5})).getSaturation(), 0.8);
    }
}

} // namespace osgLego::test
