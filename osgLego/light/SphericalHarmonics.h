#pragma once

#include <array>

#include <osg/Vec3d>

namespace osgLego
{

/** Radiance or irradiance as a sum of the nine real spherical harmonics of the first three bands.
 *
 * They have the order and constants of Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance
 * Environment Maps", 2001: Y00; Y1-1 (y), Y10 (z), Y11 (x); Y2-2 (xy), Y2-1 (yz), Y20 (3z^2 - 1), Y21 (xz),
 * Y22 (x^2 - y^2). Every function may be called from any thread.
 *
 * The constants are only in the .cpp file: shaders/light/ambient_light.glsl gets an irradiance polynomial and evaluates
 * it like evaluatePolynomial(). AmbientLightTest compares the results. */
namespace SphericalHarmonics
{

constexpr int COUNT = 9;
using Coefficients = std::array<osg::Vec3d, COUNT>;

/** The value of each harmonic in the direction of a unit vector. */
std::array<double, COUNT> evaluate(const osg::Vec3d& direction);

/** Convert the coefficients of radiance to irradiance, divided by pi, as a polynomial in the unit normal of a surface:
 * the coefficients of 1; y, z, x; xy, yz, 3z^2 - 1, xz, x^2 - y^2, each for red, green and blue. */
Coefficients toIrradiancePolynomial(const Coefficients& radiance);

/** The value of a polynomial. Can be negative if the light has too much contrast for nine harmonics. */
osg::Vec3d evaluatePolynomial(const Coefficients& polynomial, const osg::Vec3d& normal);

} // namespace SphericalHarmonics

} // namespace osgLego
