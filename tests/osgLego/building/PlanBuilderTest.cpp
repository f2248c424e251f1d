#include "../stability/BrickTowers.h"

#include <osgLego/building/PlanBuilder.h>

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A brick of 2x4 on a high column on a base, and below the free half of it an arm of 2x8 with a foot of two bricks
 * of 2x2 at its end. The brick, the arm and the foot are a submodel.
 * @param place of the column in x. The arm and the foot begin at 2. */
osg::ref_ptr<const BrickModel> createArm(int place)
{
    std::vector<Part> parts{createBrick({place, 0, 0}, 2, 8)};
    for (int z = 1; z < 5; ++z)
        parts.push_back(createBrick({place, 2, z}, 2, 2));
    for (const int z : {2, 3})
        parts.push_back(createBrick({2, 0, z}, 2, 2));
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

TEST(PlanBuilder, UnheldPartsDoNotEndWithAStepOfOnePart)
{
    // A brick on the ground, and others in the air.
    for (int number = 2; number <= 20; ++number)
    {
        std::vector<Part> parts{createBrick({0, 0, 0}, 2, 2)};
        for (int index = 0; index < number; ++index)
            parts.push_back(createBrick({3 * index, 4, 2}, 2, 2));
        const auto built = PlanBuilder(*createPartModel(std::move(parts)), {}).build();
        EXPECT_EQ(built->getUnheldParts().size(), static_cast<std::size_t>(number));
        EXPECT_GT(built->getSteps().back().parts.size(), 1u) << number;
    }
}

TEST(PlanBuilder, ASubmodelThatFallsUprightIsBuiltUpsideDownInASecondAttempt)
{
    // The foot stands below one end of the arm, which topples over; the brick lies above the middle of the arm.
    const auto built = plan(5, true);
    ASSERT_EQ(built->getSubmodels().size(), 1u);
    ASSERT_EQ(built->getSubmodels()[0].steps.size(), 1u);
    const BuildingStep& step = built->getSubmodels()[0].steps[0];
    EXPECT_EQ(step.parts.size(), 4u);
    EXPECT_TRUE(step.isFromBelow);
    EXPECT_TRUE(step.stands);
    EXPECT_TRUE(step.isChecked);
    const auto fast = plan(5, false);
    EXPECT_FALSE(fast->getSubmodels()[0].steps[0].isFromBelow)
        << "upright comes first if nobody computes that it falls";
}

TEST(PlanBuilder, ASubmodelThatFallsBothWaysStaysUpright)
{
    // Both the foot and the brick are at the same end of the arm. Placing the arm with the
    // brick does not help.
    const auto built = plan(2, true);
    ASSERT_TRUE(built);
    ASSERT_EQ(built->getSubmodels().size(), 1u);
    for (const BuildingStep& step : built->getSubmodels().back().steps)
        EXPECT_FALSE(step.isFromBelow);
    EXPECT_FALSE(built->getSubmodels().back().steps.back().stands);
}

/** Plan parts that hang from a beam of 8x2 on a column, without the check of stability. */
osg::ref_ptr<const BuildingPlan> planBelowBeam(std::vector<Part> hanging)
{
    for (int z = 0; z < 5; ++z)
        hanging.push_back(createBrick({2, 0, z}, 2, 2));
    hanging.push_back(createBrick({0, 0, 5}, 8, 2));
    PlanningOptions options;
    options.checksStability = false;
    return PlanBuilder(*createPartModel(std::move(hanging)), options).build();
}

TEST(PlanBuilder, ASubmodelIsBuiltUpsideDownIfItNeedsFewerSubmodelsThen)
{
    // A long leg of bricks 4x2 and a short one, which hangs if the long one stands on the table. The beam's area is not
    // far larger than the leg's.
    const auto built =
        planBelowBeam({createBrick({4, 0, 3}, 4, 2), createBrick({4, 0, 4}, 4, 2), createBrick({0, 0, 4}, 2, 2)});
    ASSERT_EQ(built->getSubmodels().size(), 1u);
    EXPECT_TRUE(built->getSubmodels()[0].steps[0].isFromBelow);
}

TEST(PlanBuilder, ASubmodelIsBuiltUprightIfItNeedsFewerSubmodelsThen)
{
    // A leg on an arm of 4x1, and a brick on that arm, which hangs if the beam stands on the table, though the beam is
    // far larger than the arm.
    const auto built =
        planBelowBeam({createBrick({4, 0, 1}, 4, 1), createBrick({6, 0, 2}, 2, 2), createBrick({6, 0, 3}, 2, 2),
                       createBrick({6, 0, 4}, 2, 2), createBrick({4, 0, 2}, 1, 1)});
    ASSERT_EQ(built->getSubmodels().size(), 1u);
    EXPECT_FALSE(built->getSubmodels()[0].steps[0].isFromBelow);
}

TEST(PlanBuilder, ViewsOfStepsShowTheSubmodelsThatAreAttached)
{
    // In front of a high wall are three bricks, and behind it a column with a beam, from which four bricks hang. From
    // the front, four of ten parts are visible; from the right and behind, the beam, the bricks below it, and the wall.
    std::vector<Part> parts{createBrick({0, 4, 0}, 20, 1)};
    parts.back().size[2] = 20;
    for (const int x : {4, 8, 12})
        parts.push_back(createBrick({x, 0, 0}, 2, 2));
    parts.push_back(createBrick({10, 9, 0}, 1, 1));
    parts.back().size[2] = 11;
    parts.push_back(createBrick({4, 9, 11}, 13, 1));
    for (const int x : {4, 7, 13, 16})
        parts.push_back(createBrick({x, 9, 10}, 1, 1));
    PlanningOptions options;
    options.checksStability = false;
    const auto built = PlanBuilder(*createPartModel(std::move(parts)), options).build();
    ASSERT_EQ(built->getSteps().size(), 1u);
    ASSERT_EQ(built->getSteps()[0].submodels.size(), 1u);
    EXPECT_EQ(built->getSteps()[0].parts.size(), 5u);
    EXPECT_EQ(built->getSteps()[0].turns, 1);
}

TEST(PlanBuilder, ASubmodelIsBuiltUpsideDownOnAFarLargerArea)
{
    // Three legs of 4x1, 2x1 and 1x1 below a beam of 8x2: seven and sixteen studs.
    const auto built =
        planBelowBeam({createBrick({4, 0, 4}, 4, 1), createBrick({0, 0, 4}, 2, 1), createBrick({0, 1, 4}, 1, 1)});
    ASSERT_EQ(built->getSubmodels().size(), 1u);
    EXPECT_TRUE(built->getSubmodels()[0].steps[0].isFromBelow);
}

TEST(PlanBuilder, EachSubmodelThatFallsUprightIsBuiltUpsideDownInASecondAttempt)
{
    // Two arms as above, which touch nothing else.
    std::vector<Part> parts{createBrick({0, 0, 0}, 2, 2)};
    for (const int x : {4, 24})
        for (const Part& part :
             {createBrick({x, 0, 3}, 2, 2), createBrick({x, 0, 4}, 8, 2), createBrick({x + 3, 0, 5}, 2, 4)})
            parts.push_back(part);
    const auto built = PlanBuilder(*createPartModel(std::move(parts)), {}).build();
    ASSERT_EQ(built->getSubmodels().size(), 2u);
    for (const Submodel& submodel : built->getSubmodels())
    {
        EXPECT_TRUE(submodel.steps[0].isFromBelow);
        EXPECT_TRUE(submodel.steps[0].stands);
    }
}

TEST(PlanBuilder, StepsOfSubmodelsThatAreUpsideDownAreTurnedToShowTheirParts)
{
    // From a plate on a column hang a high wall and, behind it, four bricks, which it hides if the plate is turned
    // over.
    std::vector<Part> parts{createBrick({0, 0, 0}, 1, 1), createBrick({0, 0, 21}, 20, 16)};
    parts.front().size[2] = 21;
    parts.push_back(createBrick({1, 6, 2}, 19, 1));
    parts.back().size[2] = 19;
    for (const int x : {4, 7, 13, 16})
        parts.push_back(createBrick({x, 10, 20}, 1, 1));
    PlanningOptions options;
    options.checksStability = false;
    const auto built = PlanBuilder(*createPartModel(std::move(parts)), options).build();
    ASSERT_EQ(built->getSubmodels().size(), 1u);
    for (const BuildingStep& step : built->getSubmodels()[0].steps)
    {
        EXPECT_TRUE(step.isFromBelow);
        EXPECT_TRUE(step.turns == 1 || step.turns == 2) << "from other sides, the wall is in front of the bricks";
    }
}

TEST(PlanBuilder, ProgressRisesThoughSubmodelsArePlannedLater)
{
    PlanningOptions options;
    std::vector<double> fractions;
    options.progress = [&fractions](double fraction) { fractions.push_back(fraction); };
    ASSERT_EQ(PlanBuilder(*createArm(5), options).build()->getSubmodels().size(), 1u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1.0);
}

TEST(PlanBuilder, APlanIsNullWheneverItIsCancelled)
{
    PlanningOptions options;
    options.checksStability = false;
    int numCalls = 0;
    options.isCancelled = [&numCalls] { return ++numCalls < 0; };
    ASSERT_TRUE(PlanBuilder(*createArm(5), options).build());
    const int last = numCalls;
    ASSERT_GE(last, 2) << "at least once for the model and for its submodel";
    for (int call = 1; call <= last; ++call)
    {
        numCalls = 0;
        options.isCancelled = [&] { return ++numCalls == call; };
        EXPECT_FALSE(PlanBuilder(*createArm(5), options).build()) << call;
    }
}

TEST(PlanBuilder, ASubmodelIsBuiltUpsideDownIfASubmodelWithinItFallsOtherwise)
{
    // A piece in the air: the arm that falls both ways as a submodel, on a larger base with a brick beside the column.
    // Upside down, the arm is no submodel, and the base with the brick below it is one, since it hides the brick.
    std::vector<Part> parts{createBrick({20, 0, 0}, 2, 2), createBrick({0, 0, 1}, 4, 8), createBrick({0, 6, 2}, 2, 2)};
    for (int z = 2; z < 6; ++z)
        parts.push_back(createBrick({2, 2, z}, 2, 2));
    for (const int z : {3, 4})
        parts.push_back(createBrick({2, 0, z}, 2, 2));
    parts.push_back(createBrick({2, 0, 5}, 8, 2));
    parts.push_back(createBrick({2, 0, 6}, 2, 4));
    const auto built = PlanBuilder(*createPartModel(std::move(parts)), {}).build();
    ASSERT_EQ(built->getSubmodels().size(), 2u);
    for (const Submodel& submodel : built->getSubmodels())
        for (const BuildingStep& step : submodel.steps)
            EXPECT_TRUE(step.stands);
    EXPECT_TRUE(built->getSubmodels().back().steps.front().isFromBelow);
}

} // namespace

} // namespace osgLego::test
