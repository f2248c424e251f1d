#include <osgLego/light/SphericalHarmonics.h>

namespace osgLego::SphericalHarmonics
{

namespace
{

constexpr double BAND_0 = 0.28209479177387814;  // sqrt(1 / (4 pi))
constexpr double BAND_1 = 0.48860251190291992;  // sqrt(3 / (4 pi))
constexpr double BAND_2 = 1.0925484305920792;   // sqrt(15 / (4 pi))
constexpr double BAND_2_0 = 0.3153915652525200; // sqrt(5 / (16 pi))

/** Each harmonic, divided by its monomial. */
constexpr std::array<double, COUNT> NORMALIZATION{BAND_0, BAND_1,   BAND_1, BAND_1,      BAND_2,
                                                  BAND_2, BAND_2_0, BAND_2, 0.5 * BAND_2};

/** The attenuation of each harmonic by the cosine in the irradiance, divided by pi: 1, 2/3 and 1/4 by band. */
constexpr std::array<double, COUNT> COSINE{1.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 0.25, 0.25, 0.25, 0.25, 0.25};

std::array<double, COUNT> evaluateMonomials(const osg::Vec3d& direction)
{
    const double x = direction.x();
    const double y = direction.y();
    const double z = direction.z();
    return {1.0, y, z, x, x * y, y * z, 3.0 * z * z - 1.0, x * z, x * x - y * y};
}

} // namespace

std::array<double, COUNT> evaluate(const osg::Vec3d& direction)
{
    std::array<double, COUNT> harmonics = evaluateMonomials(direction);
    for (std::size_t index = 0; index < COUNT; ++index)
        harmonics[index] *= NORMALIZATION[index];
    return harmonics;
}

Coefficients toIrradiancePolynomial(const Coefficients& radiance)
{
    Coefficients polynomial;
    for (std::size_t index = 0; index < COUNT; ++index)
        polynomial[index] = radiance[index] * (COSINE[index] * NORMALIZATION[index]);
    return polynomial;
}

osg::Vec3d evaluatePolynomial(const Coefficients& polynomial, const osg::Vec3d& normal)
{
    const std::array<double, COUNT> monomials = evaluateMonomials(normal);
    osg::Vec3d sum;
    for (std::size_t index = 0; index < COUNT; ++index)
        sum += polynomial[index] * monomials[index];
    return sum;
}

} // namespace osgLego::SphericalHarmonics
