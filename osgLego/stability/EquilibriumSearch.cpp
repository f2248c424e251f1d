#include <osgLego/stability/EquilibriumSearch.h>

#include <osgLego/data/UnionFind.h>

#include <array>
#include <limits>
#include <utility>

namespace osgLego
{

namespace
{

// The penalty of a missing newton, relative to a newton of tension: more than a single lever in pitches. Those in grids
// of 1024 cells are at most 1229 long. With a penalty of 1e7, the solver does not converge at levers of 500.
constexpr double PENALTY = 1e4;
// For a tilt, the tolerance of its tangent, and a cost of forces that does not matter within it.
constexpr double TILT_TOLERANCE = 1e-6;
constexpr double TILT_FORCE_COST = 1e-9;
// The larger ones make the equations better conditioned, but take more steps.
constexpr std::array<EquilibriumInertia, 2> OTHER_INERTIAS{{{1e-8, 1e-7, 1e-6}, {1e-7, 1e-6, 1e-7}}};

} // namespace

std::optional<Equilibrium> EquilibriumSearch::find(double capacity, const std::optional<EquilibriumTilt>& tilt)
{
    EquilibriumGoal goal{PENALTY, capacity, !tilt};
    goal.tilt = tilt;
    goal.endsIfMissing = !tilt;
    if (tilt)
    {
        // Which of the forces that allow it is of no interest.
        goal.forceCost = TILT_FORCE_COST;
        goal.gapTolerance = TILT_TOLERANCE;
    }
    std::optional<Equilibrium> best = _solver.solve(goal);
    const bool hasEndedEarly = best && best->isMissingCertain;
    if (hasEndedEarly || (best && !best->hasConverged && !tilt && isLacking(*best)))
    {
        std::optional<Equilibrium> fallen = findMissing(capacity);
        if (!fallen || (fallen->hasConverged && isLacking(*fallen))) return fallen;
    }
    goal.endsIfMissing = false;
    if (hasEndedEarly) best = _solver.solve(goal);
    for (const EquilibriumInertia& inertia : OTHER_INERTIAS)
    {
        if (!best || best->hasConverged) break;
        goal.inertia = inertia;
        std::optional<Equilibrium> other = _solver.solve(goal);
        if (!other) return std::nullopt;
        if (other->hasConverged || getCost(*other) < getCost(*best)) best = std::move(other);
    }
    return best;
}

std::optional<Equilibrium> EquilibriumSearch::findComplete(double capacity)
{
    EquilibriumGoal goal{PENALTY, capacity, true};
    goal.endsIfMissing = true;
    std::optional<Equilibrium> found = _solver.solve(goal);
    return found && isComplete(*found) ? found : std::nullopt;
}

/** The same with all costs divided by the penalty: the velocities of parts that fall are as large as the cost of
 * missing newtons, and so are the rounding errors of free forces. */
std::optional<Equilibrium> EquilibriumSearch::findMissing(double capacity)
{
    EquilibriumGoal goal{1.0, capacity, true};
    goal.tensionCost /= PENALTY;
    goal.forceCost /= PENALTY;
    goal.gapTolerance = 1e-8;
    goal.forceTolerance = 1e-7;
    std::optional<Equilibrium> found = _solver.solve(goal);
    if (found) found->prices *= PENALTY;
    return found;
}

std::vector<std::uint32_t> EquilibriumSearch::findFalling(const Equilibrium& equilibrium)
{
    std::vector<std::uint32_t> falling;
    const auto numBodies = static_cast<std::uint32_t>(equilibrium.residuals.size() / 6);
    for (std::uint32_t body = 0; body < numBodies; ++body)
        if (equilibrium.residuals.segment<6>(6 * static_cast<Eigen::Index>(body)).abs().maxCoeff() > RESIDUAL_TOLERANCE)
            falling.push_back(body);
    return falling;
}

std::vector<std::uint32_t> EquilibriumSearch::findRigidBodies(const Equilibrium& equilibrium) const
{
    constexpr double SAME = 1e-5; // of the largest velocity
    UnionFind sets;
    sets.reset(_program.getNumBodies());
    const double largest = equilibrium.velocities.lpNorm<Eigen::Infinity>();
    for (const EquilibriumProgram::Joint& joint : _program.getJoints())
    {
        if (joint.lower == EquilibriumProgram::NO_BODY) continue;
        const Wrench difference = EquilibriumProgram::getVelocity(equilibrium.velocities, joint.upper, joint.upperArm) -
                                  EquilibriumProgram::getVelocity(equilibrium.velocities, joint.lower, joint.lowerArm);
        if (difference.lpNorm<Eigen::Infinity>() <= SAME * largest) sets.join(joint.lower, joint.upper);
    }
    std::vector<std::uint32_t> bodies;
    for (std::size_t body = 0; body < sets.getCount(); ++body)
        bodies.push_back(static_cast<std::uint32_t>(sets.find(static_cast<std::int32_t>(body))));
    return bodies;
}

double EquilibriumSearch::getCost(const Equilibrium& equilibrium)
{
    return isComplete(equilibrium) ? equilibrium.tension - equilibrium.tilt : std::numeric_limits<double>::infinity();
}

} // namespace osgLego
