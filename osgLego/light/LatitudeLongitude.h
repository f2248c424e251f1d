#pragma once

#include <osg/Vec2d>
#include <osg/Vec3d>

namespace osgLego
{

/** A picture of all directions whose columns are longitudes and whose rows are latitudes.
 *
 * Coordinates (u, v) are from 0 to 1, u to the right and v upwards, like the rows of an osg::Image. +Y is in the
 * centre, +X in the right half, +Z at the top. Every function may be called from any thread. */
namespace LatitudeLongitude
{

/** The unit vector for a position in the picture. */
osg::Vec3d directionAt(double u, double v);

/** The position of a unit vector in the picture, both coordinates from 0 to 1. */
osg::Vec2d coordinatesOf(const osg::Vec3d& direction);

/** The exact solid angle, in steradians, of each pixel in a row of a picture of the given size. */
double solidAngleOf(int row, int width, int height);

} // namespace LatitudeLongitude

} // namespace osgLego
