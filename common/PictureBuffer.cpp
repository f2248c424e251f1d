#include "PictureBuffer.h"

#include <OpenImageIO/imagebufalgo.h>

namespace osgLego
{

namespace
{

const char* const STRAIGHT_ALPHA = "oiio:UnassociatedAlpha";

} // namespace

OIIO::ImageBuf toImageBuf(const osg::Image& image)
{
    const bool hasAlpha = image.getPixelFormat() == GL_RGBA;
    OIIO::ImageSpec spec(image.s(), image.t(), hasAlpha ? 4 : 3, OIIO::TypeDesc::UINT8);
    if (hasAlpha) spec.attribute(STRAIGHT_ALPHA, 1);
    OIIO::ImageBuf upsideDown(spec);
    upsideDown.set_pixels(OIIO::ROI::All(), OIIO::TypeDesc::UINT8, image.data(), OIIO::AutoStride,
                          static_cast<OIIO::stride_t>(image.getRowStepInBytes()));
    return OIIO::ImageBufAlgo::flip(upsideDown);
}

bool hasStraightAlpha(const OIIO::ImageBuf& picture)
{
    return picture.spec().alpha_channel >= 0 && picture.spec().get_int_attribute(STRAIGHT_ALPHA) != 0;
}

OIIO::ImageBuf toMultiplied(const OIIO::ImageBuf& picture)
{
    if (!hasStraightAlpha(picture)) return picture;
    OIIO::ImageBuf multiplied = OIIO::ImageBufAlgo::premult(picture.copy(OIIO::TypeDesc::FLOAT));
    multiplied.specmod().erase_attribute(STRAIGHT_ALPHA);
    return multiplied;
}

} // namespace osgLego
