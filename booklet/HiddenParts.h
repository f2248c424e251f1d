#pragma once

#include <osgLego/BrickModel.h>

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A share of the faces of a part towards the eye, except grazing ones: parts of which less is visible are hardly
 * found. */
constexpr double HARDLY_VISIBLE = 1.0 / 16.0;

/** The parts of which less than a share of the faces towards the eye is visible.
 *
 * Uses no GL. May be called from any thread.
 * @param placed the parts in place, as indices into the parts of the model.
 * @param shown the parts to find, some of `placed`.
 * @param toEye the direction to the eye, in model coordinates, of length 1.
 * @param leastShare 0 to 1.
 * @return those of `shown` that others hide, or they themselves. */
std::vector<std::uint32_t> findHiddenParts(const BrickModel& model, std::span<const std::uint32_t> placed,
                                           std::span<const std::uint32_t> shown, const glm::dvec3& toEye,
                                           double leastShare = HARDLY_VISIBLE);

} // namespace osgLego
