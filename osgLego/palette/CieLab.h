#pragma once

#include <array>
#include <cstdint>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** Convert a channel of an sRGB colour to linear light, 0 to 1. */
double toLinear(std::uint8_t channel);

/** Convert an sRGB colour to linear light. */
glm::dvec3 toLinear(const std::array<std::uint8_t, 3>& color);

/** Convert a colour in linear light, with the primaries of sRGB, to CIELAB with the white of sRGB (D65): lightness 0 to
 * 100, and a and b, which are 0 for greys. */
glm::dvec3 linearToCieLab(const glm::dvec3& color);

/** The derivatives of linearToCieLab() at a colour: a column for each channel of linear light. */
glm::dmat3 cieLabDerivatives(const glm::dvec3& color);

/** Convert an sRGB colour to CIELAB. */
glm::dvec3 toCieLab(const std::array<std::uint8_t, 3>& color);

} // namespace osgLego
