#include "BearingTests.h"

#include <osgLego/stability/SpringBalance.h>

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

std::optional<BearingForces> balance(const BearingJoints& joints, double floorPull = 0.0)
{
    const std::vector<bool> all(joints.getGraph().getNumParts(), true);
    return SpringBalance(joints).add(createNoForces(joints, floorPull), all, all);
}

TEST(SpringBalance, JointsBearWhatTheirCapacityAllows)
{
    for (const double weight : {0.0, 0.01, Cantilever::MOST})
        EXPECT_TRUE(balance(Cantilever(weight).getJoints())) << weight;
    EXPECT_FALSE(balance(Cantilever(1.0).getJoints()));
}

TEST(SpringBalance, SpringsThatPullTooMuchAreHelpedByOthers)
{
    // If two points at 1/8 pitch to the left and two in the middle pull with the capacity, the beam turns about those
    // at 1/8 pitch to the right: 2 * 0.979 * (1/4 + 1/8) = (3.5 - 1/8) * weight, for a weight of 0.2176 N.
    const std::optional<BearingForces> forces = balance(Cantilever(0.16).getJoints());
    ASSERT_TRUE(forces);
    EXPECT_GE(*std::min_element(forces->pressures.begin(), forces->pressures.end()), -BearingForces::CAPACITY);
    EXPECT_FALSE(balance(Cantilever(0.218).getJoints()));
}

TEST(SpringBalance, WhatIsInPlaceKeepsNewPartsFromTopplingOver)
{
    // As in ATableDoesNotHoldWhatTopplesOver, but with the lower brick in place already.
    const JointGraph graph({{{0, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {6, 2, 2}}});
    for (const auto& [lower, holds] : {std::pair(0.11, true), std::pair(0.09, false)})
    {
        const BearingJoints joints(graph, {lower, 0.1}, BuildingBase::TABLE);
        SpringBalance springs(joints);
        const std::optional<BearingForces> first = springs.add(createNoForces(joints), {true, false}, {true, false});
        ASSERT_TRUE(first);
        const std::optional<BearingForces> both = springs.add(*first, {true, true}, {true, true});
        ASSERT_EQ(both.has_value(), holds) << lower;
        EXPECT_NEAR(both ? both->floorLoads[0][0] : lower + 0.1, lower + 0.1, 1e-9);
    }
}

TEST(SpringBalance, OnlyPartsInsidePassOnNewWeights)
{
    // Two pillars, a beam across them, and a new brick at the left end of the beam.
    const JointGraph graph(
        {{{0, 0, 0}, {2, 2, 1}}, {{6, 0, 0}, {8, 2, 1}}, {{0, 0, 1}, {8, 2, 2}}, {{0, 0, 2}, {2, 2, 3}}});
    const BearingJoints joints(graph, {0.1, 0.1, 0.2, 0.1}, BuildingBase::TABLE);
    SpringBalance springs(joints);
    const std::vector<bool> first{true, true, true, false};
    const std::vector<bool> all(4, true);
    const std::optional<BearingForces> known = springs.add(createNoForces(joints), first, first);
    ASSERT_TRUE(known);
    const std::optional<BearingForces> both = springs.add(*known, all, all);
    const std::optional<BearingForces> left = springs.add(*known, all, {true, false, true, true});
    ASSERT_TRUE(both && left);
    EXPECT_NE(both->floorLoads[1][0], known->floorLoads[1][0]);
    EXPECT_EQ(left->floorLoads[1], known->floorLoads[1]);
    EXPECT_NEAR(left->floorLoads[0][0], known->floorLoads[0][0] + 0.1, 1e-9);
    EXPECT_EQ(left->isPlaced, all);
    EXPECT_FALSE(springs.add(*known, all, {true, true, false, true})) << "nothing bears the new brick";
}

TEST(SpringBalance, StudsOfAPlateHoldTheSumOfAllLoads)
{
    // A brick 2 x 2 on a base plate, and beams on it, whose middles are beyond it.
    std::vector<BuildingBox> boxes{{{0, 0, 0}, {2, 2, 1}}};
    for (int layer = 1; layer <= 40; ++layer)
        boxes.push_back({{0, 0, layer}, {10, 2, layer + 1}});
    const JointGraph graph(boxes);
    const BearingJoints joints(graph, std::vector<double>(boxes.size(), 0.05), BuildingBase::PLATE);
    SpringBalance springs(joints);
    std::optional<BearingForces> forces = createNoForces(joints);
    for (std::size_t numParts = 1; numParts <= boxes.size(); ++numParts)
    {
        std::vector<bool> isPlaced(boxes.size(), false);
        std::fill_n(isPlaced.begin(), numParts, true);
        const bool holdsAtOnce = springs.add(createNoForces(joints), isPlaced, isPlaced).has_value();
        forces = springs.add(*forces, isPlaced, isPlaced);
        ASSERT_EQ(forces.has_value(), holdsAtOnce) << numParts;
        if (forces) continue;
        EXPECT_GT(numParts, 3u);
        return;
    }
    FAIL() << "all beams are held";
}

TEST(SpringBalance, StudsOfAPlateHoldWhatTheirCapacityAllows)
{
    // A brick 1 x 1 presses with 0.1 N on each of four points, which reduces the pull that they already bear.
    const JointGraph graph({{{0, 0, 0}, {1, 1, 1}}});
    const BearingJoints joints(graph, {0.4}, BuildingBase::PLATE);
    EXPECT_TRUE(balance(joints, 1.078));
    EXPECT_FALSE(balance(joints, 1.080));
}

TEST(SpringBalance, EveryPointBearsTheSameOfAWeightAboveTheMiddle)
{
    const JointGraph graph({{{0, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {2, 2, 2}}});
    const std::optional<BearingForces> forces = balance(BearingJoints(graph, {1.0, 3.0}, BuildingBase::TABLE));
    ASSERT_TRUE(forces);
    ASSERT_EQ(forces->pressures.size(), 12u);
    for (const double pressure : forces->pressures)
        EXPECT_NEAR(pressure, 0.25, 1e-9);
    EXPECT_NEAR(forces->floorLoads[0][0], 4.0, 1e-9);
    EXPECT_NEAR(forces->floorLoads[0][1], 4.0, 1e-9);
    EXPECT_NEAR(forces->floorLoads[0][2], 4.0, 1e-9);
}

TEST(SpringBalance, ATableDoesNotHoldWhatTopplesOver)
{
    // A brick 2 x 2, and one 2 x 6 on it with its centre 1 pitch beyond the edge of the lower one: about that edge,
    // they are in balance if the lower one weighs as much as the upper one.
    const JointGraph graph({{{0, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {6, 2, 2}}});
    EXPECT_TRUE(balance(BearingJoints(graph, {0.11, 0.1}, BuildingBase::TABLE)));
    EXPECT_FALSE(balance(BearingJoints(graph, {0.09, 0.1}, BuildingBase::TABLE)));
    EXPECT_TRUE(balance(BearingJoints(graph, {0.09, 0.1}, BuildingBase::PLATE)));
}

TEST(SpringBalance, ReleasesCornersUntilNoneOfThemPullsAtTheTable)
{
    // Bricks 1 x 1 in a row, a beam on them, and a weight on the beam near its end, which lifts more and more of them.
    constexpr std::uint32_t NUM_BRICKS = 6;
    constexpr double WEIGHT = 0.1;
    std::vector<BuildingBox> boxes;
    for (int brick = 0; brick < static_cast<int>(NUM_BRICKS); ++brick)
        boxes.push_back({{2 * brick, 0, 0}, {2 * brick + 1, 1, 1}});
    boxes.push_back({{0, 0, 1}, {11, 1, 2}});
    boxes.push_back({{9, 0, 2}, {10, 1, 3}});
    const JointGraph graph(boxes);
    std::vector<double> weights(boxes.size(), 0.0);
    weights.back() = WEIGHT;
    const std::optional<BearingForces> forces = balance(BearingJoints(graph, weights, BuildingBase::TABLE));
    ASSERT_TRUE(forces);
    VerticalLoad sum = VerticalLoad::Zero();
    for (const VerticalLoad& load : forces->floorLoads)
    {
        EXPECT_GE(load[0], -1e-9);
        sum += load;
    }
    EXPECT_TRUE(sum.isApprox(VerticalLoad(WEIGHT, 9.5 * WEIGHT, 0.5 * WEIGHT), 1e-6)) << sum;
    EXPECT_EQ(forces->floorLoads[0][0], 0.0) << "the far end is lifted";
}

} // namespace

} // namespace osgLego::test
