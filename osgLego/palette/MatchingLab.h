#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Convert a colour in linear light, with the primaries of sRGB, to the place at which it is matched to plastics:
 * CIELAB, in which vivid blues and yellows are moved. Colours match if ciede2000() of their places is small.
 *
 * CIELAB shows lines of constant hue as curves near blue (Hung and Berns 1995): the hue of the vivid blue of displays
 * is that of purple plastics. Blues therefore have the hue of OKLab (Ottosson 2020), in which those lines are straight,
 * plus 20 degrees.
 *
 * The vivid yellow of displays is lighter and greener than any plastic, so that cream would be its nearest. It moves
 * towards the best examples of yellow, which are darker and redder (Berlin and Kay 1969).
 *
 * All other colours, among them greys and the plastics of the palette "ldraw", keep their places. The result is
 * continuous, with the chroma of CIELAB. May be called from any thread. */
glm::dvec3 linearToMatchingLab(const glm::dvec3& color);

/** Convert an sRGB colour to the place at which it is matched. */
glm::dvec3 toMatchingLab(const std::array<std::uint8_t, 3>& color);

} // namespace osgLego
