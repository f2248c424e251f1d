#pragma once

#include <osgLego/stability/BearingJoints.h>

#include <utility>
#include <vector>

namespace osgLego::test
{

/** Forces on no parts. @param floorPull pull at points of the base, in newtons. */
inline BearingForces createNoForces(const BearingJoints& joints, double floorPull)
{
    BearingForces forces = osgLego::createNoForces(joints);
    forces.floorPull = floorPull;
    return forces;
}

/** A beam 2 x 8 of the given weight in newtons, on the last two studs of a heavy brick 2 x 8 on a table.
 *
 * The beam's centre is 3.5 pitches from these studs. Four of its six points are an eighth of a pitch to the left and to
 * the right of them: springs there, or forces spread evenly, push and pull with weight * (3.5 * 1/8 / (4/64)) = 7 *
 * weight, and at all six with weight / 6. So 0.979 N, the capacity less a thousandth, is reached at 0.1433 N. */
class Cantilever
{
public:
    static constexpr double MOST = 0.1432;
    static constexpr double TOO_MUCH = 0.1434;

    explicit Cantilever(double weight) :
        _graph({{{0, 0, 0}, {8, 2, 1}}, {{7, 0, 1}, {15, 2, 2}}}), _joints(_graph, {10.0, weight}, BuildingBase::TABLE)
    {
    }

    const BearingJoints& getJoints() const { return _joints; }

private:
    JointGraph _graph;
    BearingJoints _joints;
};

} // namespace osgLego::test
