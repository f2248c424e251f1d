#include <osgLego/building/StepViews.h>

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
    const int turned = views.show({1});
    EXPECT_TRUE(turned == 1 || turned == 2) << "from the right or from behind, not " << turned;
    EXPECT_EQ(views.show({3}), turned) << "it is visible from all sides";
    EXPECT_NE(views.show({2}), 2) << "the wall hides it from behind";
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
