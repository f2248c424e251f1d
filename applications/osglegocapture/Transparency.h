#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** A picture with a transparent background, from the same picture over black and over white.
 *
 * @param overBlack, overWhite RGB of 8 bits, of the same size.
 * @return RGBA of 8 bits: the colours that, blended by alpha over any background, show the scene before it; not
 * multiplied by alpha, and black where nothing is. */
osg::ref_ptr<osg::Image> makeTransparent(const osg::Image& overBlack, const osg::Image& overWhite);

} // namespace osgLego
