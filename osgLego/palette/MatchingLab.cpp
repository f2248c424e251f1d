#include <osgLego/palette/MatchingLab.h>

#include <osgLego/palette/CieLab.h>

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

namespace osgLego
{

namespace
{

/** The hue of a place in CIELAB or OKLab in degrees, 0 to 360. */
double hueOf(const glm::dvec3& place)
{
    const double hue = glm::degrees(std::atan2(place.z, place.y));
    return hue < 0.0 ? hue + 360.0 : hue;
}

/** Ottosson's OKLab of a colour in linear light with the primaries of sRGB. */
glm::dvec3 linearToOkLab(const glm::dvec3& color)
{
    constexpr glm::dmat3 TO_CONES(0.4122214708, 0.2119034982, 0.0883024619, 0.5363325363, 0.6806995451, 0.2817188376,
                                  0.0514459929, 0.1073969566, 0.6299787005);
    constexpr glm::dmat3 TO_PLACE(0.2104542553, 1.9779984951, 0.0259040371, 0.7936177850, -2.4285922050, 0.7827717662,
                                  -0.0040720468, 0.4505937099, -0.8086757660);
    const glm::dvec3 cones = TO_CONES * color;
    return TO_PLACE * glm::dvec3(std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z));
}

/** A range of vivid colours that move, and its margin, in which colours move only part of the way. */
struct VividColors
{
    double hue;          // in the middle, in degrees of OKLab
    double width;        // up to this distance from it, colours move the whole way
    double reach;        // from this distance on, they keep their places
    double leastChroma;  // up to this chroma in CIELAB, they keep their places
    double enoughChroma; // from this chroma on, they move the whole way

    /** How much of the way a colour moves, 0 to 1. */
    double shareOf(double okHue, double chroma) const
    {
        const double near = (reach - std::abs(okHue - hue)) / (reach - width);
        const double vivid = (chroma - leastChroma) / (enoughChroma - leastChroma);
        return std::clamp(near, 0.0, 1.0) * std::clamp(vivid, 0.0, 1.0);
    }
};

// The blue of displays has the hue 264, and violet begins at 280. Blue plastics, which have hues of at most 260 and
// chromas of about 48, keep their places. Their hues in CIELAB are about 20 degrees larger than in OKLab.
constexpr VividColors BLUES{271.0, 8.0, 14.0, 48.0, 60.0};
constexpr double BLUE_HUE = 20.0; // degrees in CIELAB, more than in OKLab

// The yellow of displays has the hue 110 and a chroma of 97, plastic yellow 90 and 83, lime 122 and 80, and cream 101
// and 64. It moves two thirds of the way to plastic yellow, which becomes nearest.
constexpr VividColors YELLOWS{108.0, 2.0, 14.0, 74.0, 88.0};
constexpr double YELLOW_HUE = -10.0; // in degrees of CIELAB
constexpr double YELLOW_LIGHTNESS = -10.0;

} // namespace

glm::dvec3 linearToMatchingLab(const glm::dvec3& color)
{
    const glm::dvec3 place = linearToCieLab(color);
    const double chroma = std::hypot(place.y, place.z);
    if (chroma <= std::min(BLUES.leastChroma, YELLOWS.leastChroma)) return place;
    const double okHue = hueOf(linearToOkLab(color));
    const double blue = BLUES.shareOf(okHue, chroma);
    const double yellow = YELLOWS.shareOf(okHue, chroma);
    if (blue == 0.0 && yellow == 0.0) return place;
    const double hue = hueOf(place);
    const double moved = glm::radians(hue + blue * (okHue + BLUE_HUE - hue) + yellow * YELLOW_HUE);
    return {place.x + yellow * YELLOW_LIGHTNESS, chroma * std::cos(moved), chroma * std::sin(moved)};
}

glm::dvec3 toMatchingLab(const std::array<std::uint8_t, 3>& color)
{
    return linearToMatchingLab(toLinear(color));
}

} // namespace osgLego
