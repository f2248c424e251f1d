#pragma once

#include <osgLego/stability/BearingJoints.h>

#include <vector>

namespace osgLego
{

/** Adds the weights of more parts to forces in equilibrium: each part passes its load on to the parts below it or, if
 * it hangs, to those above it, spread over its contact points as evenly as possible.
 *
 * If the forces stay within the capacity of the joints, the parts stand: such forces are a solution of the linear
 * program of computeStability(). If they exceed it, the parts may stand with other forces. The time grows with the
 * number of parts whose load changes.
 *
 * Immutable once created; every function may be called from any thread. */
class WeightFlow
{
public:
    /** @param joints must outlive this object. */
    explicit WeightFlow(const BearingJoints& joints);

    /** Add parts to those that are in place.
     * @param forces changed only on success.
     * @param isPlaced those that are to be in place, which include all that are.
     * @return whether forces within the capacity were found. */
    bool add(BearingForces& forces, const std::vector<bool>& isPlaced) const;

private:
    class Pass;

    const BearingJoints& _joints;
    std::vector<std::uint32_t> _fromTop; // parts, the highest first
};

} // namespace osgLego
