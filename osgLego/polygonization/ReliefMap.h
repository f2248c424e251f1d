#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** The slopes of the relief on a stud's disk, for shaders/polygonization/brick_surface.glsl.
 *
 * RGBA of 32-bit floats, square, a side that is a power of two, with all mipmaps: the slope along u and along v for a
 * relief that is one radius of the disk high, and the mean of their squares summed, which in the smaller maps is more
 * than the square of the mean slopes by what the slopes vary (Olano and Baker 2010, "LEAN mapping"). The last channel
 * is 0. May be called from any thread.
 * @param heights by the first channel, 0 to 1, as BrickAppearance::reliefImage; null: the project's own, which is
 * shared: to be read alone. */
osg::ref_ptr<osg::Image> createReliefMap(const osg::Image* heights);

} // namespace osgLego
