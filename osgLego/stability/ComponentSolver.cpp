#include <osgLego/stability/ComponentSolver.h>

#include <osgLego/stability/EquilibriumSearch.h>
#include <osgLego/stability/JointLoads.h>
#include <osgLego/stability/LargeComponent.h>

#include <algorithm>
#include <limits>

namespace osgLego
{

namespace
{

constexpr double TENSION_TOLERANCE = ComponentStability::TENSION_TOLERANCE;

/** Solves the linear programs of one component. */
class ComponentSolver
{
public:
    ComponentSolver(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                    std::span<const Contact> contacts, const std::function<bool()>& isCancelled) :
        _contacts(contacts),
        _search(boxes, parts, contacts, isCancelled), _program(_search.getProgram())
    {
    }

    std::optional<ComponentStability> solve()
    {
        std::optional<Equilibrium> equilibrium = _search.find(StabilityReport::CAPACITY, {});
        if (!equilibrium) return std::nullopt;
        ComponentStability result;
        result.tension = getTension(*equilibrium);
        result.isTensionBound = !equilibrium->hasConverged;
        if (!EquilibriumSearch::isKnown(*equilibrium))
        {
            giveUp(result);
            return result;
        }
        if (EquilibriumSearch::isComplete(*equilibrium))
            // The program keeps to the capacity, which rounding errors may exceed.
            result.tension = std::min(result.tension, StabilityReport::CAPACITY);
        else
        {
            result.falling = EquilibriumSearch::findFalling(*equilibrium);
            result.bodies = _search.findRigidBodies(*equilibrium);
            // A higher capacity helps only if the forces use all of the capacity.
            if (equilibrium->tension > StabilityReport::CAPACITY - TENSION_TOLERANCE)
            {
                const std::optional<Equilibrium> stronger = _search.find(2.0 * StabilityReport::CAPACITY, {});
                if (!stronger) return std::nullopt;
                result.tension = getTension(*stronger);
                result.isTensionBound = !stronger->hasConverged;
            }
        }
        result.weakest = findWeakest(*equilibrium);
        result.loads = findLoads(_program, findPulls(*equilibrium));
        return result;
    }

private:
    double getTension(const Equilibrium& equilibrium) const
    {
        if (!EquilibriumSearch::isComplete(equilibrium)) return std::numeric_limits<double>::infinity();
        return _program.getNumDrags() == 0 ? 0.0 : equilibrium.tension;
    }

    /** Say that the forces are too imprecise to know whether the parts stand. */
    void giveUp(ComponentStability& result) const
    {
        result.isKnown = false;
        result.loads.assign(_program.getNumBodies(), std::numeric_limits<float>::quiet_NaN());
    }

    /** The joint whose capacity matters most. */
    std::optional<StabilityReport::Joint> findWeakest(const Equilibrium& equilibrium) const
    {
        std::optional<StabilityReport::Joint> weakest;
        if (equilibrium.tension < TENSION_TOLERANCE) return weakest;
        double most = 1e-6;
        for (std::size_t index = 0; index < _contacts.size(); ++index)
        {
            const EquilibriumProgram::Joint& joint = _program.getJoints()[index];
            const double price =
                equilibrium.prices
                    .segment(static_cast<Eigen::Index>(joint.first), static_cast<Eigen::Index>(joint.end - joint.first))
                    .sum();
            if (price <= most) continue;
            most = price;
            weakest = {_contacts[index].lower, _contacts[index].upper};
        }
        return weakest;
    }

    /** For each joint, the largest drag. */
    std::vector<double> findPulls(const Equilibrium& equilibrium) const
    {
        std::vector<double> pulls;
        for (const EquilibriumProgram::Joint& joint : _program.getJoints())
        {
            double most = 0.0;
            for (std::size_t force = joint.first; force < joint.end; ++force)
                if (_program.getKind(force) == EquilibriumProgram::DRAG)
                    most = std::max(most, equilibrium.forces[static_cast<Eigen::Index>(force)]);
            pulls.push_back(most);
        }
        return pulls;
    }

    const std::span<const Contact> _contacts;
    EquilibriumSearch _search;
    const EquilibriumProgram& _program;
};

} // namespace

std::optional<ComponentStability> solveComponent(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                                 std::span<const Contact> contacts,
                                                 const std::function<bool()>& isCancelled)
{
    std::optional<ComponentStability> large = solveLargeComponent(boxes, parts, contacts, isCancelled);
    if (large) return large;
    if (isCancelled && isCancelled()) return std::nullopt;
    return ComponentSolver(boxes, parts, contacts, isCancelled).solve();
}

std::optional<BodyFall> findFall(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                 std::span<const std::uint32_t> bodies, std::span<const Contact> contacts,
                                 const std::function<bool()>& isCancelled)
{
    EquilibriumSearch search(boxes, parts, contacts, isCancelled, bodies);
    const std::optional<Equilibrium> equilibrium = search.find(StabilityReport::CAPACITY, {});
    if (!equilibrium) return std::nullopt;
    BodyFall fall;
    if (!equilibrium->hasConverged) return fall;
    fall.falling = EquilibriumSearch::findFalling(*equilibrium);
    fall.bodies = search.findRigidBodies(*equilibrium);
    return fall;
}

} // namespace osgLego
