#pragma once

#include <OpenImageIO/imagebuf.h>
#include <osg/Image>

namespace osgLego
{

/** Convert a picture drawn by OSG, 8-bit RGB or RGBA, for OpenImageIO: top row first, and straight alpha marked as
 * such. */
OIIO::ImageBuf toImageBuf(const osg::Image& image);

/** Whether a picture has straight alpha: colours not yet multiplied by it. */
bool hasStraightAlpha(const OIIO::ImageBuf& picture);

/** The picture with colours multiplied by alpha, in single precision if it had straight alpha. */
OIIO::ImageBuf toMultiplied(const OIIO::ImageBuf& picture);

} // namespace osgLego
