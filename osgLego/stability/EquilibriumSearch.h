#pragma once

#include <osgLego/stability/InteriorPointSolver.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace osgLego
{

/** Solves linear programs of the equilibrium of some parts, with several attempts at each.
 *
 * A solver that does not converge starts again: with smaller costs if parts fall, and with other proximal terms. If
 * it never converges, forces that are in equilibrium nevertheless prove that one exists, and bound its tension or tilt.
 *
 * Usage:
 *
 *     EquilibriumSearch search(boxes, parts, contacts, isCancelled);
 *     const std::optional<Equilibrium> found = search.find(0.98, {});
 *     if (!found) ...                           // cancelled
 *     else if (!search.isKnown(*found)) ...     // unknown
 *     else if (search.isComplete(*found)) ...   // nothing is missing
 *
 * One thread at a time. */
class EquilibriumSearch
{
public:
    /** The largest residual of an equilibrium, in newtons, or newtons times the pitch: a quarter of a percent of the
     * weight of a brick 1 x 1. */
    static constexpr double RESIDUAL_TOLERANCE = 1e-5;

    /** @param boxes those of all parts of the model.
     * @param parts indices into `boxes`, in ascending order.
     * @param contacts between these parts, and of them with the base.
     * @param isCancelled may be empty.
     * @param bodies for each part, the number of its rigid body, from 0 on; if empty, each part is a body. Contacts are
     * only between bodies.
     * @param given as for EquilibriumProgram. */
    EquilibriumSearch(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                      std::span<const Contact> contacts, const std::function<bool()>& isCancelled,
                      std::span<const std::uint32_t> bodies = {}, std::span<const Wrench> given = {}) :
        _program(boxes, parts, contacts, bodies, given),
        _solver(_program, isCancelled)
    {
    }

    const EquilibriumProgram& getProgram() const { return _program; }

    /** Find the least tension, or the greatest tilt.
     * @param capacity the upper limit of drags, in newtons.
     * @param tilt if it is set, it is maximized.
     * @return nothing if it was cancelled. */
    std::optional<Equilibrium> find(double capacity, const std::optional<EquilibriumTilt>& tilt);

    /** Find forces of which nothing is missing, in one attempt.
     * @return nothing if there are none, if that is not known, or if it was cancelled. */
    std::optional<Equilibrium> findComplete(double capacity);

    /** Whether the forces tell anything: they are optimal or, at least, in equilibrium. */
    static bool isKnown(const Equilibrium& equilibrium) { return equilibrium.hasConverged || equilibrium.isBalanced; }
    static bool isComplete(const Equilibrium& equilibrium)
    {
        return isKnown(equilibrium) && equilibrium.residuals.abs().maxCoeff() <= RESIDUAL_TOLERANCE;
    }
    /** The bodies that lack forces, ascending. */
    static std::vector<std::uint32_t> findFalling(const Equilibrium& equilibrium);
    /** For each body, the lowest of those that touch each other and move as one when they fall. */
    std::vector<std::uint32_t> findRigidBodies(const Equilibrium& equilibrium) const;

private:
    /** Whether newtons are missing, even if they are not known precisely. */
    static bool isLacking(const Equilibrium& equilibrium)
    {
        return equilibrium.residuals.abs().maxCoeff() > RESIDUAL_TOLERANCE;
    }
    std::optional<Equilibrium> findMissing(double capacity);
    static double getCost(const Equilibrium& equilibrium);

    const EquilibriumProgram _program;
    InteriorPointSolver _solver;
};

} // namespace osgLego
