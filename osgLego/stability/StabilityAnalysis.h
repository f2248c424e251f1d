#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/Stability.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace osgLego
{

/** Computes whether subsets of the parts of a model stand, such as those that are in place after a step of building.
 *
 * Contacts are found once, and components that are the same as in the last call are not computed again.
 *
 * Usage:
 *
 *     StabilityAnalysis analysis(*model, BuildingBase::TABLE);
 *     const std::optional<StabilityReport> report = analysis.solve(parts);
 *     if (!report) ... // cancelled
 *
 * Uses no GL, and all threads that oneTBB gives the caller. One thread at a time for each object.
 */
class StabilityAnalysis
{
public:
    /** @param model with parts that are in getPartTypes(); needed only during this call.
     * @param weights those on parts that solve() is not given do not count.
     * @throws std::invalid_argument if a weight is on a part that does not exist, is negative or not finite. */
    StabilityAnalysis(const BrickModel& model, BuildingBase base, std::span<const AddedWeight> weights = {});
    ~StabilityAnalysis();

    StabilityAnalysis(const StabilityAnalysis&) = delete;
    StabilityAnalysis& operator=(const StabilityAnalysis&) = delete;

    /** Let a function end solve() early by returning true; it is called from any thread. */
    void setCancellation(std::function<bool()> isCancelled);

    /** Compute whether some parts stand, without the others, on the base below the lowest of them.
     * @param parts indices into BrickModel::getParts(), in any order, each once.
     * @return a report whose indices are those of the model, with a load of 0 for parts that are not among `parts`;
     * nothing if it was cancelled. */
    std::optional<StabilityReport> solve(std::span<const std::uint32_t> parts);

    /** Parts joined to rigid bodies: for each part of the model, some part of its body, the same for all of them. */
    using RigidBodies = std::vector<std::uint32_t>;

    /** The parts that moved as one when parts fell in the last solve(), or stood together, as rigid bodies. If parts
     * are added, few of these bodies are mostly enough to see that parts still fall. */
    const RigidBodies& getBodies() const;

    /** Find parts that fall even if parts are joined to rigid bodies, so that parts fall without that, too. For few
     * bodies, this takes much less time than solve().
     * @param parts those in place, as in solve().
     * @param bodies becomes the bodies that move as one, if some fall.
     * @return the parts of bodies that lack forces; none if all bodies stand, which proves nothing, or if that is not
     * known; nothing if it was cancelled. */
    std::optional<std::vector<std::uint32_t>> findFalling(std::span<const std::uint32_t> parts, RigidBodies& bodies);

    /** Add StabilityReport::tiltAngles. @param report that of solve() for the same parts.
     * @return false if it was cancelled. */
    bool addTilt(std::span<const std::uint32_t> parts, StabilityReport& report);

private:
    class Implementation;
    std::unique_ptr<Implementation> _implementation;
};

} // namespace osgLego
