#include <osgLego/palette/CieLab.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace osgLego
{

namespace
{

std::array<double, 256> makeLinearTable()
{
    std::array<double, 256> table{};
    for (std::size_t channel = 0; channel < table.size(); ++channel)
    {
        const double encoded = static_cast<double>(channel) / 255.0;
        table[channel] = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
    }
    return table;
}

// The tristimulus values of the primaries of sRGB (IEC 61966-2-1), in columns; those of white are their sum.
constexpr glm::dmat3 PRIMARIES(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920, 0.1804375, 0.0721750,
                               0.9503041);

glm::dvec3 toTristimulus(const glm::dvec3& color)
{
    return PRIMARIES * color / (PRIMARIES[0] + PRIMARIES[1] + PRIMARIES[2]);
}

constexpr double END_OF_LINE = 6.0 / 29.0; // of the function below

/** CIE 15's function of a tristimulus value, as a fraction of that of white. */
double compress(double value)
{
    return value > END_OF_LINE * END_OF_LINE * END_OF_LINE ? std::cbrt(value)
                                                           : value / (3.0 * END_OF_LINE * END_OF_LINE) + 4.0 / 29.0;
}

/** The derivative of that function. */
double compressionAt(double value)
{
    const double root = std::max(std::cbrt(value), END_OF_LINE);
    return 1.0 / (3.0 * root * root);
}

} // namespace

double toLinear(std::uint8_t channel)
{
    static const std::array<double, 256> table = makeLinearTable();
    return table[channel];
}

glm::dvec3 toLinear(const std::array<std::uint8_t, 3>& color)
{
    return {toLinear(color[0]), toLinear(color[1]), toLinear(color[2])};
}

glm::dvec3 linearToCieLab(const glm::dvec3& color)
{
    const glm::dvec3 value = toTristimulus(color);
    const double x = compress(value.x);
    const double y = compress(value.y);
    const double z = compress(value.z);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

glm::dmat3 cieLabDerivatives(const glm::dvec3& color)
{
    const glm::dvec3 value = toTristimulus(color);
    const glm::dvec3 white = PRIMARIES[0] + PRIMARIES[1] + PRIMARIES[2];
    glm::dmat3 derivatives;
    for (int channel = 0; channel < 3; ++channel)
    {
        const double x = compressionAt(value.x) * PRIMARIES[channel].x / white.x;
        const double y = compressionAt(value.y) * PRIMARIES[channel].y / white.y;
        const double z = compressionAt(value.z) * PRIMARIES[channel].z / white.z;
        derivatives[channel] = {116.0 * y, 500.0 * (x - y), 200.0 * (y - z)};
    }
    return derivatives;
}

glm::dvec3 toCieLab(const std::array<std::uint8_t, 3>& color)
{
    return linearToCieLab(toLinear(color));
}

} // namespace osgLego
