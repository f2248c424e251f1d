#pragma once

#include <osgLego/stability/ContactFinder.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace osgLego
{

/** The tilt of a base up to which parts stand. */
struct ComponentTilt
{
    double tangent = 0.0;        //!< of the angle, from 0 to TiltSolver's MOST_TANGENT
    bool isTangentBound = false; //!< whether it may be larger
    bool isKnown = true;         //!< whether `tangent` is known at all
};

/** Finds the greatest tilt of the base at which parts that touch each other stand, each connected to the base. Every
 * smaller tilt in the same direction is possible, too.
 *
 * A tilt by the angle a has the weights cos(a) * (weight * tan(a) sideways and weight downwards). Divided by cos(a),
 * they are linear in tan(a), and only the limit of drags is not: it is CAPACITY / cos(a). A linear program therefore
 * has its tangent as the limit, which is below it, first the one at a tilt of 0; programs with tangents at the result
 * follow as long as they find more.
 *
 * Usage:
 *
 *     const std::optional<ComponentTilt> tilt = TiltSolver(boxes, parts, contacts, isCancelled).solve({1.0, 0.0});
 */
class TiltSolver
{
public:
    static constexpr double MOST_TANGENT = 1.0;

    /** The arguments must outlive this object.
     * @param boxes those of all parts of the model.
     * @param parts indices into `boxes`, in ascending order, which stand without a tilt.
     * @param contacts between these parts, and of them with the base: a rough table, or studs; rough
     * studs hold parts that would turn about a single one.
     * @param isCancelled may be empty. */
    TiltSolver(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts, std::span<const Contact> contacts,
               const std::function<bool()>& isCancelled) :
        _boxes(boxes),
        _parts(parts), _contacts(contacts), _isCancelled(isCancelled)
    {
    }

    /** @param direction horizontal, in which the base descends, of length 1.
     * @return nothing if it was cancelled. */
    std::optional<ComponentTilt> solve(const Eigen::Vector2d& direction) const;

private:
    std::span<const PartBox> _boxes;
    std::span<const std::uint32_t> _parts;
    std::span<const Contact> _contacts;
    const std::function<bool()>& _isCancelled;
};

} // namespace osgLego
