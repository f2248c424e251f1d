#pragma once

#include <osgLego/stability/ComponentSolver.h>

namespace osgLego
{

/** Find out whether a component stands of which the linear program would take minutes.
 *
 * If springs hold it safely, it stands, and their tension is a bound. If groups of neighbouring parts fall though each
 * is rigid, parts fall; it is not known which, and the groups are given instead.
 *
 * @param boxes, parts, contacts, isCancelled as for solveComponent().
 * @return nothing if the component is not that large, if neither is found, or if it was cancelled. `loads` are those of
 * the forces that were found, or not a number if parts fall. */
std::optional<ComponentStability> solveLargeComponent(std::span<const PartBox> boxes,
                                                      std::span<const std::uint32_t> parts,
                                                      std::span<const Contact> contacts,
                                                      const std::function<bool()>& isCancelled);

} // namespace osgLego
