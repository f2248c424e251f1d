#include <osgLego/stability/TiltSolver.h>

#include <osgLego/StabilityReport.h>
#include <osgLego/stability/EquilibriumSearch.h>

#include <cmath>

namespace osgLego
{

std::optional<ComponentTilt> TiltSolver::solve(const Eigen::Vector2d& direction) const
{
    constexpr int MOST_ROUNDS = 5;
    constexpr double TANGENT_TOLERANCE = 1e-5;
    EquilibriumSearch search(_boxes, _parts, _contacts, _isCancelled);
    ComponentTilt result;
    result.isKnown = false;
    for (int round = 0; round < MOST_ROUNDS; ++round)
    {
        // The tangent of CAPACITY * sqrt(1 + t * t), at the tilt that is known.
        const double known = result.tangent;
        const double base = StabilityReport::CAPACITY / std::sqrt(1.0 + known * known);
        const std::optional<Equilibrium> found = search.find(
            base, EquilibriumTilt{search.getProgram().createSideLoad(direction), MOST_TANGENT, base * known});
        if (!found) return std::nullopt;
        // A program without a solution at the first tilt is one of rounding errors: the parts stand without a tilt.
        if (!EquilibriumSearch::isComplete(*found)) break;
        result.isKnown = true;
        const bool hasEnded = found->tilt <= known + TANGENT_TOLERANCE;
        result.isTangentBound = !found->hasConverged || !hasEnded;
        if (hasEnded) break;
        // An interior point does not reach the bound.
        result.tangent = found->tilt > MOST_TANGENT - TANGENT_TOLERANCE ? MOST_TANGENT : found->tilt;
    }
    return result;
}

} // namespace osgLego
