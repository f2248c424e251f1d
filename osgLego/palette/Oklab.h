#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Convert a channel of an sRGB colour to linear light, 0 to 1. */
double toLinear(std::uint8_t channel);

/** Convert a colour in linear light, with the primaries of sRGB, to Oklab (Ottosson 2020): lightness 0 to 1, and a and
 * b of about -0.4 to 0.4. */
glm::dvec3 linearToOklab(const glm::dvec3& color);

/** Convert an sRGB colour to Oklab. */
glm::dvec3 toOklab(const std::array<std::uint8_t, 3>& color);

} // namespace osgLego
