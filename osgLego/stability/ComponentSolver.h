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
    /** The least upper limit of drags, in newtons, with which the parts are in equilibrium; infinite if
     * 2 * StabilityReport::CAPACITY does not suffice. */
    double tension = 0.0;
    bool isTensionBound = false;                   //!< whether a lower limit may do
    bool isKnown = true;                           //!< whether it is known if the parts are in equilibrium
    std::optional<StabilityReport::Joint> weakest; //!< the joint that needs this limit
    std::vector<float> loads;                      //!< for each part, as in StabilityReport
    std::vector<std::uint32_t> falling;            //!< indices into `loads`
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

} // namespace osgLego
