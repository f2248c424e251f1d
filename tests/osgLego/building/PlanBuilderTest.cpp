#include "../stability/BrickTowers.h"

#include <osgLego/building/PlanBuilder.h>

#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A brick of 2x4 on a high column on a base, and below the free half of it an arm of 2x8 with a foot of 2x2 at its
 * end. The brick, the arm and the foot are a submodel.
 * @param place of the column in x. The arm and the foot begin at 2. */
osg::ref_ptr<const BrickModel> createArm(int place)
{
    std::vector<Part> parts{createBrick({place, 0, 0}, 2, 8)};
    for (int z = 1; z < 5; ++z)
        parts.push_back(createBrick({place, 2, z}, 2, 2));
    parts.push_back(createBrick({2, 0, 3}, 2, 2));
    parts.push_back(createBrick({2, 0, 4}, 8, 2));
    parts.push_back(createBrick({place, 0, 5}, 2, 4));
    return createPartModel(std::move(parts));
}

osg::ref_ptr<const BuildingPlan> plan(int place, bool checksStability)
{
    PlanningOptions options;
    options.checksStability = checksStability;
    return PlanBuilder(*createArm(place), options).build();
}

TEST(PlanBuilder, ASubmodelThatFallsUprightIsBuiltUpsideDownInASecondAttempt)
{
    // The foot stands below one end of the arm, which topples over; the brick lies above the middle of the arm.
    const auto built = plan(5, true);
    ASSERT_EQ(built->getSubmodels().size(), 1u);
    ASSERT_EQ(built->getSubmodels()[0].steps.size(), 1u);
    const BuildingStep& step = built->getSubmodels()[0].steps[0];
    EXPECT_EQ(step.parts.size(), 3u);
    EXPECT_TRUE(step.isFromBelow);
    EXPECT_TRUE(step.stands);
    EXPECT_TRUE(step.isChecked);
    const auto fast = plan(5, false);
    EXPECT_FALSE(fast->getSubmodels()[0].steps[0].isFromBelow)
        << "upright comes first if nobody computes that it falls";
}

TEST(PlanBuilder, ASubmodelThatFallsBothWaysStaysUpright)
{
    // Both the foot and the brick are at the same end of the arm. To make it stand, the arm hangs from the brick in a
    // submodel of its own, in vain.
    const auto built = plan(2, true);
    ASSERT_TRUE(built);
    ASSERT_EQ(built->getSubmodels().size(), 2u);
    for (const BuildingStep& step : built->getSubmodels().back().steps)
        EXPECT_FALSE(step.isFromBelow);
    EXPECT_FALSE(built->getSubmodels().back().steps.back().stands);
}

} // namespace

} // namespace osgLego::test
