#pragma once

#include <osg/Vec3d>

namespace osgLego
{

/** The radiance of the built-in sky and ground in the direction of a unit vector, Z up: a soft overcast sky with a
 * large warm glow to the front right (+X, -Y), a soft horizon, and warm grey ground. Linear and relative. */
osg::Vec3d computeSkyRadiance(const osg::Vec3d& direction);

} // namespace osgLego
