#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create the map of the slopes of the relief on a stud's disk, for shaders/polygonization/brick_surface.glsl.
 *
 * A square RGBA image of 32-bit floats with all mipmaps, whose side is a power of two. The channels are the slopes
 * along u and v for a relief as high as the radius of the disk, the mean of the sum of their squares, and 0. In
 * mipmaps, the mean square exceeds the square of the mean slopes by the variance (Olano and Baker 2010, "LEAN
 * mapping"). May be called from any thread.
 * @param heights the first channel gives heights, 0 to 1, see BrickAppearance::reliefImage. Null: the built-in relief;
 * its map is shared, only read it. */
osg::ref_ptr<osg::Image> createReliefMap(const osg::Image* heights);

} // namespace osgLego
