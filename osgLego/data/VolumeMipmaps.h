#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create an image with all mipmaps of a volume: each texel of a level, whose sides are half as long, rounded down, is
 * the mean of the texels that it covers. The driver could make them, too, but software renderers compile programs for
 * that, which takes 0.1 seconds, and in core profiles OSG 3.6.5 makes none. May be called from any thread.
 * @param image of GL_RGBA and GL_UNSIGNED_BYTE, without mipmaps. */
osg::ref_ptr<osg::Image> createVolumeMipmaps(const osg::Image& image);

} // namespace osgLego
