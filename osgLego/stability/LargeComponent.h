#pragma once

#include <osgLego/stability/ComponentSolver.h>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Find out whether a component stands of which the linear program would take minutes.
 *
 * If springs hold it safely, it stands, and their tension is a bound. Otherwise see findFallOfGroups().
 *
 * @param boxes, parts, contacts, isCancelled as for solveComponent().
 * @return nothing if the component is not that large, if neither is found, or if it was cancelled. `loads` are those of
 * the forces that were found, or not a number if parts fall. */
std::optional<ComponentStability> solveLargeComponent(std::span<const PartBox> boxes,
                                                      std::span<const std::uint32_t> parts,
                                                      std::span<const Contact> contacts,
                                                      const std::function<bool()>& isCancelled);

/** Find out that a component falls, if groups of neighbouring parts fall though each is rigid: joining parts only adds
 * forces.
 *
 * If few parts are in such groups, they are then looked at one by one, with the other groups.
 *
 * @param size that of a group, in studs and plates.
 * @return the parts, or the groups, that fall, with an infinite tension as a bound; nothing if it is not known that any
 * do, or if it was cancelled. */
std::optional<ComponentStability> findFallOfGroups(std::span<const PartBox> boxes, std::span<const std::uint32_t> parts,
                                                   std::span<const Contact> contacts, const glm::ivec3& size,
                                                   const std::function<bool()>& isCancelled);

} // namespace osgLego
