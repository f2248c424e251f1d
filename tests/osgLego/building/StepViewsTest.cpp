#include <osgLego/building/StepViews.h>

#include <array>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(StepViews, TurnOnlyWhenOtherPartsHideTheNewOnes)
{
    // A high wall along x, a brick behind it, one in front of it and one on it.
    const std::vector<BuildingBox> boxes{
        {{0, 4, 0}, {20, 6, 9}}, {{8, 9, 0}, {12, 11, 1}}, {{8, 0, 0}, {12, 2, 1}}, {{8, 4, 9}, {12, 6, 10}}};
    StepViews views(boxes, 1.2);
    EXPECT_EQ(views.show({0}), 0) << "the front right";
    EXPECT_EQ(views.show({1}), 1) << "from the right, the first of two turns that show it";
    EXPECT_EQ(views.show({3}), 1) << "it is visible from all sides";
    EXPECT_EQ(views.show({2}), 3) << "from the left, the first turn after that from behind, where the wall hides it";
}

TEST(StepViews, TurnCounterClockwiseFromAbove)
{
    // A brick in the corner of two high walls, beside two of its sides. Seen from above, the eye is 33 degrees to the
    // right of the front, and goes to the right, to the back and to the left.
    const BuildingBox brick{{40, 40, 0}, {42, 42, 1}};
    const std::array<std::array<BuildingBox, 2>, 4> corners{{
        {{{{36, 10, 0}, {37, 44, 20}}, {{36, 44, 0}, {70, 45, 20}}}}, // left and behind
        {{{{36, 37, 0}, {37, 70, 20}}, {{36, 36, 0}, {70, 37, 20}}}}, // left and in front
        {{{{45, 37, 0}, {46, 70, 20}}, {{12, 36, 0}, {46, 37, 20}}}}, // right and in front
        {{{{45, 10, 0}, {46, 44, 20}}, {{12, 44, 0}, {46, 45, 20}}}}, // right and behind
    }};
    for (int turns = 0; turns < 4; ++turns)
    {
        const auto& walls = corners[static_cast<std::size_t>(turns)];
        const std::vector<BuildingBox> boxes{brick, walls[0], walls[1]};
        StepViews views(boxes, 1.2);
        EXPECT_EQ(views.show({1, 2}), 0) << turns;
        EXPECT_EQ(views.show({0}), turns);
    }
}

TEST(StepViews, APartIsVisibleIfAQuarterOfItsFacesIs)
{
    // A brick of 2x2 has eight faces towards the eye: four on top, two in front and two at the right. Bricks cover the
    // top and the front, so that a quarter of the faces is left; or half of the right side, too.
    const std::vector<BuildingBox> boxes{
        {{0, 2, 0}, {2, 4, 1}}, {{0, 0, 0}, {2, 2, 1}}, {{0, 2, 1}, {2, 4, 2}}, {{2, 3, 0}, {3, 4, 1}}};
    StepViews quarter(boxes, 1.2);
    EXPECT_EQ(quarter.show({1, 2}), 0);
    EXPECT_EQ(quarter.show({0}), 0) << "two of eight faces";
    StepViews eighth(boxes, 1.2);
    EXPECT_EQ(eighth.show({1, 2, 3}), 0);
    EXPECT_EQ(eighth.show({0}), 1) << "one of eight faces; from the right, two more behind";
}

TEST(StepViews, StayWhenHalfOfTheNewPartsAreHiddenFromEverywhere)
{
    // A pit, at the bottom of which a brick can't be seen.
    std::vector<BuildingBox> boxes{{{4, 4, 0}, {6, 6, 1}}};
    for (const int low : {2, 6})
    {
        boxes.push_back({{low, 2, 0}, {low + 2, 8, 20}});
        boxes.push_back({{4, low, 0}, {6, low + 2, 20}});
    }
    StepViews views(boxes, 1.2);
    EXPECT_EQ(views.show({1, 2, 3, 4}), 0);
    EXPECT_EQ(views.show({0}), 0);
}

} // namespace

} // namespace osgLego::test
