#pragma once

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** Compute a picture with a transparent background from the same picture over black and over white.
 *
 * @param overBlack, overWhite 8-bit RGB, of the same size.
 * @return 8-bit RGBA with straight alpha, to be blended over any background; black where the scene is empty. */
osg::ref_ptr<osg::Image> makeTransparent(const osg::Image& overBlack, const osg::Image& overWhite);

} // namespace osgLego
