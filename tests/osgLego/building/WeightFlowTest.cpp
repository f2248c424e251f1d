#include <osgLego/building/SpringBalance.h>
#include <osgLego/building/WeightFlow.h>

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

} // namespace

} // namespace osgLego::test
