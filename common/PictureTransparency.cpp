#include "PictureTransparency.h"

#include <algorithm>

namespace osgLego
{

namespace
{

constexpr int OPAQUE = 255;

/** The opacity of a pixel. It is the same for all channels; their mean has the smallest rounding error. */
int alphaOf(const unsigned char* overBlack, const unsigned char* overWhite)
{
    int shown = 0;
    for (int channel = 0; channel < 3; ++channel)
        shown += overWhite[channel] - overBlack[channel];
    return std::clamp(OPAQUE - (shown + 1) / 3, 0, OPAQUE);
}

void makePixel(const unsigned char* overBlack, const unsigned char* overWhite, unsigned char* result)
{
    const int alpha = alphaOf(overBlack, overWhite);
    for (int channel = 0; channel < 3; ++channel)
    {
        const int color = alpha == 0 ? 0 : (overBlack[channel] * OPAQUE + alpha / 2) / alpha;
        result[channel] = static_cast<unsigned char>(std::min(color, OPAQUE));
    }
    result[3] = static_cast<unsigned char>(alpha);
}

} // namespace

osg::ref_ptr<osg::Image> makeTransparent(const osg::Image& overBlack, const osg::Image& overWhite)
{
    osg::ref_ptr<osg::Image> result = new osg::Image;
    result->allocateImage(overBlack.s(), overBlack.t(), 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int row = 0; row < overBlack.t(); ++row)
        for (int column = 0; column < overBlack.s(); ++column)
            makePixel(overBlack.data(column, row), overWhite.data(column, row), result->data(column, row));
    return result;
}

} // namespace osgLego
