#pragma once

#include <osgLego/BrickModel.h>

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The parts of which hardly anything is visible: less than a sixteenth of the faces towards the eye.
 *
 * Uses no GL. May be called from any thread.
 * @param placed the parts in place, as indices into the parts of the model.
 * @param shown the parts to find, some of `placed`.
 * @param toEye the direction to the eye, in model coordinates, of length 1.
 * @return those of `shown` that others hide, or they themselves. */
std::vector<std::uint32_t> findHiddenParts(const BrickModel& model, std::span<const std::uint32_t> placed,
                                           std::span<const std::uint32_t> shown, const glm::dvec3& toEye);

} // namespace osgLego
