#include "BearingTests.h"

#include <osgLego/stability/WeightFlow.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

bool flows(const BearingJoints& joints, double floorPull = 0.0)
{
    BearingForces forces = createNoForces(joints, floorPull);
    return WeightFlow(joints).add(forces, std::vector<bool>(joints.getGraph().getNumParts(), true));
}

TEST(WeightFlow, JointsBearWhatTheirCapacityAllows)
{
    for (const double weight : {0.0, 0.01, Cantilever::MOST})
        EXPECT_TRUE(flows(Cantilever(weight).getJoints())) << weight;
    for (const double weight : {Cantilever::TOO_MUCH, 1.0})
        EXPECT_FALSE(flows(Cantilever(weight).getJoints())) << weight;
}

TEST(WeightFlow, StudsOfAPlateHoldWhatTheirCapacityAllows)
{
    // Two beams of 14x1 studs side by side, with their ends on a weightless brick of 2x2. At the joint of a beam of the
    // weight F, eight points at the distances 0.25, 0.5, 0.5 and 0.75 bear the torque 6 F: one pulls with 1.88 F. Below
    // the brick, six points for each beam, at 0.375, 0.5 and 0.75, bear it: one pulls with 2.19 F, at most 0.98 N.
    const JointGraph graph({{{0, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {14, 1, 2}}, {{0, 1, 1}, {14, 2, 2}}});
    const auto holds = [&graph](BuildingBase base, double weight, double floorPull) {
        return flows(BearingJoints(graph, {0.0, weight, weight}, base), floorPull);
    };
    EXPECT_TRUE(holds(BuildingBase::PLATE, 0.44, 0.0));
    EXPECT_FALSE(holds(BuildingBase::PLATE, 0.46, 0.0));
    EXPECT_TRUE(holds(BuildingBase::PLATE, 0.22, 0.48)) << "half of the capacity is left";
    EXPECT_FALSE(holds(BuildingBase::PLATE, 0.23, 0.48));
    EXPECT_FALSE(holds(BuildingBase::TABLE, 0.1, 0.0)) << "it topples over";
}

TEST(WeightFlow, PressureOnAPlateReducesThePullThatItAlreadyBears)
{
    // A brick 1 x 1 presses with 0.1 N on each of four points.
    const JointGraph graph({{{0, 0, 0}, {1, 1, 1}}});
    const BearingJoints joints(graph, {0.4}, BuildingBase::PLATE);
    EXPECT_TRUE(flows(joints, 1.078));
    EXPECT_FALSE(flows(joints, 1.080));
}

TEST(WeightFlow, PartsThatHangBelowOneAnotherPassTheirWeightsUpwards)
{
    // Two bricks 2 x 2 below each other, below the middle of a beam on two columns. Each joint has twelve points, and
    // the upper one holds both: 12 * 0.979 N = 11.75 N.
    const JointGraph graph({{{0, 0, 0}, {2, 2, 3}},
                            {{6, 0, 0}, {8, 2, 3}},
                            {{0, 0, 3}, {8, 2, 4}},
                            {{3, 0, 2}, {5, 2, 3}},
                            {{3, 0, 1}, {5, 2, 2}}});
    const auto holds = [&graph](double upper, double lower) {
        return flows(BearingJoints(graph, {0.0, 0.0, 0.0, upper, lower}, BuildingBase::TABLE));
    };
    EXPECT_TRUE(holds(5.87, 5.87));
    EXPECT_FALSE(holds(5.88, 5.88));
    EXPECT_TRUE(holds(0.0, 11.74));
    EXPECT_FALSE(holds(0.0, 11.76));
}

} // namespace

} // namespace osgLego::test
