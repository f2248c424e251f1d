#include <osgLego/BuildingPlan.h>

#include <numeric>
#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

BuildingStep createStep(std::vector<std::uint32_t> parts, std::vector<std::uint32_t> submodels = {}, int turns = 0,
                        bool isFromBelow = false)
{
    BuildingStep step;
    step.parts = std::move(parts);
    step.submodels = std::move(submodels);
    step.turns = turns;
    step.isFromBelow = isFromBelow;
    return step;
}

TEST(BuildingPlan, StepsMayAttachOnlySubmodels)
{
    const auto plan =
        BuildingPlan::create(3, {createStep({2}), createStep({}, {0}, 3)}, {{{createStep({1}), createStep({0})}}});
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->getOrder(), (std::vector<std::uint32_t>{2, 1, 0}));
}

TEST(BuildingPlan, EveryStepMustPlaceSomething)
{
    EXPECT_FALSE(BuildingPlan::create(1, {createStep({0}), createStep({})}));
    EXPECT_FALSE(BuildingPlan::create(1, {createStep({0}, {0})}, {{{createStep({})}}}));
    EXPECT_FALSE(BuildingPlan::create(1, {createStep({0}, {0})}, {{}}));
}

TEST(BuildingPlan, MeasuresSubmodelsWithoutPartsThatNothingHolds)
{
    // Submodel 0 contains 1, and 2 is a piece that nothing holds.
    const std::vector<Submodel> submodels{
        {{createStep({1, 2}), createStep({}, {1})}}, {{createStep({3, 4})}}, {{createStep({5, 6, 7, 8, 9})}}};
    BuildingStep falling = createStep({0}, {0});
    falling.stands = false;
    const auto plan = BuildingPlan::create(10, {falling, createStep({}, {2})}, submodels, {5, 6, 7, 8, 9});
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->getLargestSubmodel(), 4u);
    EXPECT_EQ(plan->getDeepestSubmodel(), 2u);
    EXPECT_EQ(plan->getNumFalling(), 1u);
    EXPECT_TRUE(plan->keepsLimits());
    EXPECT_EQ(BuildingPlan::create(1, {createStep({0})})->getDeepestSubmodel(), 0u);
}

TEST(BuildingPlan, StepsOfSubmodelsInAHandDoNotCountAsFalling)
{
    for (const std::uint32_t numParts : {4u, 5u})
    {
        std::vector<std::uint32_t> parts(numParts - 1);
        std::iota(parts.begin(), parts.end(), 1u);
        Submodel submodel{{createStep(parts), createStep({numParts})}};
        submodel.steps[0].stands = false;
        const auto plan = BuildingPlan::create(numParts + 1, {createStep({0}), createStep({}, {0})}, {submodel});
        EXPECT_EQ(plan->getNumFalling(), numParts == 5 ? 1u : 0u);
    }
}

TEST(BuildingPlan, LimitsAreFoundToBeExceeded)
{
    const auto create = [](std::size_t numParts, std::uint32_t depth)
    {
        std::vector<std::uint32_t> parts(numParts);
        std::iota(parts.begin(), parts.end(), 0u);
        std::vector<Submodel> submodels{{{createStep(parts)}}};
        while (submodels.size() < depth)
            submodels.push_back({{createStep({}, {static_cast<std::uint32_t>(submodels.size() - 1)})}});
        return BuildingPlan::create(numParts, {createStep({}, {depth - 1})}, submodels);
    };
    EXPECT_TRUE(create(150, 3)->keepsLimits());
    EXPECT_FALSE(create(151, 1)->keepsLimits());
    EXPECT_FALSE(create(1, 4)->keepsLimits());
    EXPECT_TRUE(create(150, 3)->exceedsLimitsLessThan(*create(151, 1)));
    EXPECT_TRUE(create(151, 4)->exceedsLimitsLessThan(*create(151, 5)));
    EXPECT_FALSE(create(1, 1)->exceedsLimitsLessThan(*create(150, 3)));
    EXPECT_FALSE(create(151, 4)->exceedsLimitsLessThan(*create(160, 3)));
    EXPECT_TRUE(create(160, 3)->exceedsLimitsLessThan(*create(151, 4)));
}

TEST(BuildingPlan, StepsAfterWhichToHoldTheModelAreLimited)
{
    const auto create = [](std::uint32_t numFalling)
    {
        std::vector<BuildingStep> steps;
        for (std::uint32_t part = 0; part < 10; ++part)
        {
            steps.push_back(createStep({part}));
            steps.back().stands = part >= numFalling;
        }
        return BuildingPlan::create(10, steps);
    };
    EXPECT_TRUE(create(5)->keepsLimits());
    EXPECT_FALSE(create(6)->keepsLimits());
    EXPECT_TRUE(create(6)->exceedsLimitsLessThan(*create(7)));
    EXPECT_FALSE(create(4)->exceedsLimitsLessThan(*create(5)));
    EXPECT_FALSE(create(7)->exceedsLimitsLessThan(*create(6)));
    // A submodel that is too large instead.
    std::vector<std::uint32_t> parts(BuildingPlan::MOST_SUBMODEL_PARTS + 1);
    std::iota(parts.begin(), parts.end(), 0u);
    const auto large = BuildingPlan::create(parts.size(), {createStep({}, {0})}, {{{createStep(parts)}}});
    EXPECT_TRUE(large->exceedsLimitsLessThan(*create(7)));
    // 30 parts are as bad as a step.
    parts.resize(BuildingPlan::MOST_SUBMODEL_PARTS + 30);
    std::iota(parts.begin(), parts.end(), 0u);
    const auto larger = BuildingPlan::create(parts.size(), {createStep({}, {0})}, {{{createStep(parts)}}});
    EXPECT_FALSE(larger->exceedsLimitsLessThan(*create(6)));
    EXPECT_FALSE(create(6)->exceedsLimitsLessThan(*larger));
    EXPECT_FALSE(create(7)->exceedsLimitsLessThan(*large));
}

TEST(BuildingPlan, ThereAreFourTurns)
{
    for (int turns = -2; turns < 7; ++turns)
    {
        EXPECT_EQ(BuildingPlan::create(1, {createStep({0}, {}, turns)}) != nullptr, turns >= 0 && turns <= 3) << turns;
        const auto plan = BuildingPlan::create(1, {createStep({}, {0})}, {{{createStep({0}, {}, turns)}}});
        EXPECT_EQ(plan != nullptr, turns >= 0 && turns <= 3) << turns;
    }
}

TEST(BuildingPlan, OnlyWholeSubmodelsAreBuiltFromBelow)
{
    EXPECT_FALSE(BuildingPlan::create(1, {createStep({0}, {}, 0, true)}));
    for (const bool first : {false, true})
        for (const bool second : {false, true})
        {
            const Submodel submodel{{createStep({0}, {}, 0, first), createStep({1}, {}, 0, second)}};
            const auto plan = BuildingPlan::create(2, {createStep({}, {0})}, {submodel});
            EXPECT_EQ(plan != nullptr, first == second) << first << second;
        }
    // A submodel may be the other way up than the one in which it is.
    EXPECT_TRUE(
        BuildingPlan::create(2, {createStep({}, {0})}, {{{createStep({0}, {1}, 0, true)}}, {{createStep({1})}}}));
}

TEST(BuildingPlan, CountsUncheckedStepsOfTheModelAndOfSubmodels)
{
    BuildingStep checked = createStep({2}, {0});
    checked.isChecked = true;
    const auto plan = BuildingPlan::create(4, {checked, createStep({3})}, {{{createStep({1}), createStep({0})}}});
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->getNumUnchecked(), 3u);
}

TEST(BuildingPlan, UnheldPartsAreInAscendingOrder)
{
    const std::vector<BuildingStep> steps{createStep({0, 1, 2})};
    for (const std::vector<std::uint32_t>& good : {std::vector<std::uint32_t>{}, {2}, {0, 2}, {0, 1, 2}})
    {
        const auto plan = BuildingPlan::create(3, steps, {}, good);
        ASSERT_TRUE(plan);
        EXPECT_EQ(plan->getUnheldParts(), good);
    }
    for (const std::vector<std::uint32_t>& bad : {std::vector<std::uint32_t>{1, 0}, {1, 1}, {3}, {0, 3}})
        EXPECT_FALSE(BuildingPlan::create(3, steps, {}, bad));
}

} // namespace

} // namespace osgLego::test
