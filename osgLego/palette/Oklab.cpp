#include <osgLego/palette/Oklab.h>

#include <cmath>

namespace osgLego
{

double toLinear(std::uint8_t channel)
{
    const double encoded = channel / 255.0;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

glm::dvec3 linearToOklab(const glm::dvec3& color)
{
    const double l = std::cbrt(0.4122214708 * color.r + 0.5363325363 * color.g + 0.0514459929 * color.b);
    const double m = std::cbrt(0.2119034982 * color.r + 0.6806995451 * color.g + 0.1073969566 * color.b);
    const double s = std::cbrt(0.0883024619 * color.r + 0.2817188376 * color.g + 0.6299787005 * color.b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

glm::dvec3 toOklab(const std::array<std::uint8_t, 3>& color)
{
    return linearToOklab({toLinear(color[0]), toLinear(color[1]), toLinear(color[2])});
}

} // namespace osgLego
