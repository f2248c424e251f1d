#pragma once

#include <array>

#include <osg/Vec3d>

namespace osgLego
{

/** Radiance, or irradiance, by the nine real spherical harmonics of the first three bands.
 *
 * In the order and with the constants of Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance
 * Environment Maps", 2001: Y00; Y1-1 (y), Y10 (z), Y11 (x); Y2-2 (xy), Y2-1 (yz), Y20 (3z^2 - 1), Y21 (xz),
 * Y22 (x^2 - y^2). Every function may be called from any thread. */
namespace SphericalHarmonics
{

constexpr int COUNT = 9;
using Coefficients = std::array<osg::Vec3d, COUNT>;

/** The value of each harmonic in the direction of a unit vector. */
std::array<double, COUNT> evaluate(const osg::Vec3d& direction);

/** The irradiance over pi upon a surface with that unit normal, red, green and blue, from the coefficients of the
 * radiance. Below 0 where the light has more contrast than nine harmonics can tell. */
osg::Vec3d irradiance(const Coefficients& radiance, const osg::Vec3d& normal);

} // namespace SphericalHarmonics

} // namespace osgLego
