#include <osgLego/stability/SpringBalance.h>
#include <osgLego/stability/WeightFlow.h>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A column with a beam of eight studs on it, of the given weights in newtons, that overlap by a number of studs. */
class Cantilever
{
public:
    Cantilever(int overlap, double beamWeight) :
        _graph({{{0, 0, 0}, {8, 2, 1}}, {{8 - overlap, 0, 1}, {16 - overlap, 2, 2}}}),
        _joints(_graph, {10.0, beamWeight}, BuildingBase::TABLE), _none{{false, false},
                                                                        std::vector<double>(_joints.getPoints().size()),
                                                                        std::vector<VerticalLoad>(2, {0.0, 0.0, 0.0})}
    {
    }

    bool flows()
    {
        BearingForces forces = _none;
        return WeightFlow(_joints).add(forces, {true, true});
    }
    bool isBalanced() { return SpringBalance(_joints).add(_none, {true, true}).has_value(); }

private:
    JointGraph _graph;
    BearingJoints _joints;
    BearingForces _none;
};

TEST(WeightFlow, JointsBearWhatTheirCapacityAllows)
{
    // Two studs at the end of the beam: their points reach 0.25 studs outwards and 0.125 inwards, and four of them pull
    // with at most 0.98 N. The beam's centre is 3.5 studs away, so that 0.1 N are borne, and 1 N are not.
    for (const double weight : {0.0, 0.01, 0.1})
    {
        EXPECT_TRUE(Cantilever(1, weight).flows()) << weight;
        EXPECT_TRUE(Cantilever(1, weight).isBalanced()) << weight;
    }
    EXPECT_FALSE(Cantilever(1, 1.0).flows());
    EXPECT_FALSE(Cantilever(1, 1.0).isBalanced());
}

TEST(WeightFlow, StudsOfAPlateHoldWhatTheirCapacityAllows)
{
    // Two beams of 14x1 studs side by side, with their ends on a weightless brick of 2x2. At the joint of a beam of the
    // weight F, eight points at the distances 0.25, 0.5, 0.5 and 0.75 bear the torque 6 F: one pulls with 1.88 F. Below
    // the brick, six points for each beam, at 0.375, 0.5 and 0.75, bear it: one pulls with 2.19 F, at most 0.98 N.
    const JointGraph graph({{{0, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {14, 1, 2}}, {{0, 1, 1}, {14, 2, 2}}});
    const auto flows = [&graph](BuildingBase base, double weight, double floorPull)
    {
        const BearingJoints joints(graph, {0.0, weight, weight}, base);
        BearingForces forces{std::vector<bool>(3, false), std::vector<double>(joints.getPoints().size(), 0.0),
                             std::vector<VerticalLoad>(3, {0.0, 0.0, 0.0}), floorPull};
        return WeightFlow(joints).add(forces, {true, true, true});
    };
    EXPECT_TRUE(flows(BuildingBase::PLATE, 0.44, 0.0));
    EXPECT_FALSE(flows(BuildingBase::PLATE, 0.46, 0.0));
    EXPECT_TRUE(flows(BuildingBase::PLATE, 0.22, 0.48)) << "half of the capacity is left";
    EXPECT_FALSE(flows(BuildingBase::PLATE, 0.23, 0.48));
    EXPECT_FALSE(flows(BuildingBase::TABLE, 0.1, 0.0)) << "it topples over";
}

} // namespace

} // namespace osgLego::test
