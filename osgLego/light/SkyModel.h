#pragma once

#include <osg/Vec3d>

namespace osgLego
{

/** The linear, relative radiance of the built-in sky and ground in the direction of a unit vector, Z up: a soft sky
 * with a large warm glow above the front (-Y) and slightly to the right (+X), a soft horizon, and dark ground, so that
 * each face of a brick is lit differently. */
osg::Vec3d computeSkyRadiance(const osg::Vec3d& direction);

} // namespace osgLego
