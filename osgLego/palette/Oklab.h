#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Convert an sRGB colour to Oklab (Ottosson 2020): lightness 0 to 1, and a and b of about -0.4 to 0.4. */
glm::dvec3 toOklab(const std::array<std::uint8_t, 3>& color);

} // namespace osgLego
