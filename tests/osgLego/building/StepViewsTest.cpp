#include <osgLego/building/StepViews.h>

#include <osgLego/GridLimits.h>

#include <HeapSize.h>

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

TEST(StepViews, FacesSeenEdgeOnShowNoPart)
{
    // A wall in front of a part and a roof on it, seen straight from the front; its ends, which are open, are edge-on.
    const std::vector<BuildingBox> boxes{{{0, 2, 0}, {2, 10, 1}}, {{0, 0, 0}, {2, 2, 3}}, {{0, 2, 1}, {2, 10, 2}}};
    for (const double azimuth : {0.0, 180.0, 4.0})
    {
        std::vector<BuildingBox> turned = boxes;
        if (azimuth == 180.0) turned[1] = {{0, 10, 0}, {2, 12, 3}};
        StepViews views(turned, 1.2, {azimuth, 20.0});
        EXPECT_EQ(views.show({1, 2}), 0) << azimuth;
        EXPECT_FALSE(views.canShow({0}, false)) << azimuth;
        EXPECT_EQ(views.show({0}), 1) << azimuth;
    }
    // From above, the top always counts.
    const std::vector<BuildingBox> open(boxes.begin(), boxes.end() - 1);
    StepViews above(open, 0.4, {33.0, BuildingView::MOST_ELEVATION});
    EXPECT_EQ(above.show({1}), 0);
    EXPECT_TRUE(above.canShow({0}, false));
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

TEST(StepViews, TurnIfOtherPartsHideMoreThanHalfOfTheNewOnes)
{
    // A high wall along x, one brick in front of it and several behind it.
    std::vector<BuildingBox> boxes{{{0, 4, 0}, {40, 6, 12}}, {{18, 0, 0}, {20, 2, 1}}};
    for (const int x : {14, 18, 22})
        boxes.push_back({{x, 8, 0}, {x + 2, 10, 1}});
    StepViews half(boxes, 1.2);
    EXPECT_EQ(half.show({0}), 0);
    EXPECT_EQ(half.show({1, 2}), 0) << "no other view shows more";
    StepViews third(boxes, 1.2);
    EXPECT_EQ(third.show({0}), 0);
    EXPECT_EQ(third.show({1, 2, 3}), 1);
}

TEST(StepViews, TurnIfOtherPartsHideNearlyAllOfOnePart)
{
    // A high wall along x, one brick behind it and three in front of it.
    std::vector<BuildingBox> boxes{{{0, 4, 0}, {40, 6, 12}}, {{18, 8, 0}, {20, 10, 1}}};
    for (const int x : {4, 10, 16})
        boxes.push_back({{x, 0, 0}, {x + 2, 2, 1}});
    StepViews views(boxes, 1.2);
    EXPECT_EQ(views.show({0}), 0);
    EXPECT_FALSE(views.canShow({1, 2, 3, 4}, false));
    EXPECT_TRUE(views.canShow({1}, true)) << "from behind";
    EXPECT_TRUE(views.canShow({2, 3, 4}, false));
    EXPECT_EQ(views.show({2, 3, 4}), 0) << "canShow() has put nothing in place";
}

TEST(StepViews, SeeOverWallsWhoseHeightTheAngleAllows)
{
    // A tile five studs behind a long wall. The eye looks down by 30 degrees along the diagonal, so that it sees over a
    // wall of up to tan(30) * 5 / cos(33) = 3.4 studs: two bricks of 1.2, or eight plates of 0.4.
    const auto show = [](int wall, double cellHeight)
    {
        const std::vector<BuildingBox> boxes{{{0, 4, 0}, {80, 5, wall}}, {{40, 10, 0}, {41, 11, 1}}};
        StepViews views(boxes, cellHeight);
        views.show({0});
        return views.show({1});
    };
    EXPECT_EQ(show(2, 1.2), 0);
    EXPECT_EQ(show(5, 1.2), 1);
    EXPECT_EQ(show(7, 0.4), 0);
    EXPECT_EQ(show(14, 0.4), 1);
}

TEST(StepViews, MemoryFollowsThePartsNotTheirDistance)
{
    const glm::ivec3 largest = GridLimits::getLargest(2);
    const std::vector<BuildingBox> boxes{{{0, 0, 0}, {2, 2, 1}}, {largest - glm::ivec3(2, 2, 1), largest}};
    const std::size_t before = getHeapSize();
    StepViews views(boxes, 1.2);
    EXPECT_EQ(views.show({0, 1}), 0);
    EXPECT_LT(getHeapSize() - before, HEAP_OF_FEW_BRICKS);
}

} // namespace

} // namespace osgLego::test
