#pragma once

#include <osgLego/StabilityReport.h>
#include <osgLego/stability/ContactFinder.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace osgLego
{

/** The stability of parts that touch each other. */
struct ComponentStability
{
    static constexpr double TENSION_TOLERANCE = 1e-6; //!< newtons; a tension below counts as 0

    /** The least upper limit of drags, in newtons, with which the parts are in equilibrium; infinite if
     * 2 * StabilityReport::CAPACITY does not suffice, or, as a bound, if that is not known. */
    double tension = 0.0;
    bool isTensionBound = false;                   //!< whether a lower limit may do
    bool isKnown = true;                           //!< whether it is known if the parts are in equilibrium
    std::optional<StabilityReport::Joint> weakest; //!< the joint that needs this limit
    std::vector<float> loads;                      //!< for each part, as in StabilityReport
    std::vector<std::uint32_t> falling;            //!< indices into `loads`
    /** If parts fall, for each part, the lowest of those that touch each other and move as one, or of its group. */
    std::vector<std::uint32_t> bodies;
};

/** Compute the stability of parts that touch each other, each connected to the base.
 * @param boxes those of all parts of the model.
 * @param parts indices into `boxes`, in ascending order.
 * @param contacts between these parts, and of them with the base.
 * @param isCancelled may be empty.
 * @return nothing if it was cancelled. */
std::optional<ComponentStability> solveComponent(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                                 std::span<const Contact> contacts,
                                                 const std::function<bool()>& isCancelled);

/** The fall of rigid bodies. */
struct BodyFall
{
    std::vector<std::uint32_t> falling; //!< the bodies that lack forces; empty if none does
    std::vector<std::uint32_t> bodies;  //!< for each body, the lowest of those that touch each other and move as one
};

/** Find the bodies that fall if parts are joined to rigid bodies. If some fall, parts fall without that, too.
 * @param bodies for each part, the number of its body, from 0 on.
 * @param contacts between bodies, and of them with the base.
 * @return no falling bodies, too, if that is not known; nothing if it was cancelled. Otherwise as solveComponent(). */
std::optional<BodyFall> findFall(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                 std::span<const std::uint32_t> bodies, std::span<const Contact> contacts,
                                 const std::function<bool()>& isCancelled);

} // namespace osgLego
