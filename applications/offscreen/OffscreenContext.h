#pragma once

#include <string>

#include <osg/GraphicsContext>
#include <osg/ref_ptr>

namespace osgLego
{

/** Make a GL context that needs no display: compatibility profile, RGBA of 8 bits, depth of 24, stencil of 8.
 *
 * Through EGL (a GPU's device if there is one, Mesa's surfaceless platform otherwise), or, in a program that is linked
 * with osgLegoOsMesa, through OSMesa. It is realized and not current when this returns.
 * @param width, height of its own frame buffer, in pixels, at least 1.
 * @return null, with the reason in `error`, when there is none to be had. */
osg::ref_ptr<osg::GraphicsContext> createOffscreenContext(int width, int height, std::string& error);

} // namespace osgLego
