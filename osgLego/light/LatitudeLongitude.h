#pragma once

#include <osg/Vec2d>
#include <osg/Vec3d>

namespace osgLego
{

/** The picture of all directions whose columns are longitudes and whose rows are latitudes.
 *
 * Coordinates (u, v) run from 0 to 1, u to the right and v upwards, as rows of an osg::Image do. The middle looks along
 * +Y, the right half towards +X, the upper one towards +Z. Every function may be called from any thread. */
namespace LatitudeLongitude
{

/** The unit vector that a place in the picture stands for. */
osg::Vec3d directionAt(double u, double v);

/** The place of a unit vector, both coordinates from 0 to 1. */
osg::Vec2d coordinatesOf(const osg::Vec3d& direction);

/** The solid angle, in steradians, of each pixel in a row of a picture of that size; exact. */
double solidAngleOf(int row, int width, int height);

} // namespace LatitudeLongitude

} // namespace osgLego
