#include <osgLego/light/SphericalHarmonics.h>

namespace osgLego::SphericalHarmonics
{

namespace
{

/** What the cosine of a surface's irradiance leaves of each harmonic, over pi: 1, 2/3 and 1/4 by band. */
constexpr std::array<double, COUNT> COSINE{1.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 0.25, 0.25, 0.25, 0.25, 0.25};

} // namespace

std::array<double, COUNT> evaluate(const osg::Vec3d& direction)
{
    const double x = direction.x();
    const double y = direction.y();
    const double z = direction.z();
    constexpr double BAND_1 = 0.48860251190291992;  // sqrt(3 / (4 pi))
    constexpr double BAND_2 = 1.0925484305920792;   // sqrt(15 / (4 pi))
    constexpr double BAND_2_0 = 0.3153915652525200; // sqrt(5 / (16 pi))
    return {0.28209479177387814,                    // sqrt(1 / (4 pi))
            BAND_1 * y,          BAND_1 * z,
            BAND_1 * x,          BAND_2 * x * y,
            BAND_2 * y * z,      BAND_2_0 * (3.0 * z * z - 1.0),
            BAND_2 * x * z,      0.5 * BAND_2 * (x * x - y * y)};
}

osg::Vec3d irradiance(const Coefficients& radiance, const osg::Vec3d& normal)
{
    const std::array<double, COUNT> harmonics = evaluate(normal);
    osg::Vec3d sum;
    for (std::size_t index = 0; index < COUNT; ++index)
        sum += radiance[index] * (COSINE[index] * harmonics[index]);
    return sum;
}

} // namespace osgLego::SphericalHarmonics
