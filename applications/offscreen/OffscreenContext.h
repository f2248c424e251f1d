#pragma once

#include <string>

#include <osg/GraphicsContext>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create a GL context that needs no display: compatibility profile unless `coreVersion` is given, 8-bit RGBA, 24-bit
 * depth, 8-bit stencil.
 *
 * Programs linked with osgLegoOsMesa use OSMesa; all others use EGL, on a GPU if there is one, otherwise on Mesa's
 * surfaceless platform. The context is realized but not current when this function returns.
 * @param width, height of the context's own frame buffer, in pixels, at least 1.
 * @param display 0; or 1 for a context that is drawn in another thread than those of display 0. In llvmpipe, contexts
 * of different displays share nothing, while those of one display occasionally crash if several threads draw: up to
 * Mesa 22.3 at least, llvmpipe_flush_resource() reads the scenes of the others without a lock.
 * @param coreVersion of a context of the core profile, such as "4.1"; empty for the compatibility profile. EGL only.
 * @return null, with the reason in `error`, if no context can be created. */
osg::ref_ptr<osg::GraphicsContext> createOffscreenContext(int width, int height, std::string& error, int display = 0,
                                                          const std::string& coreVersion = {});

} // namespace osgLego
