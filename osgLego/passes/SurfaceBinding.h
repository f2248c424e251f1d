#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <osg/State>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** The texture of a surface as shaders/passes/surface_color.glsl wants it, with all of its mipmaps. Needs no context.
 */
osg::ref_ptr<osg::Texture2D> createSurfaceTexture(const SurfaceTexture& surface);

/** Binds what shaders/passes/surface_color.glsl needs for a batch: its texture to unit 0, its environment to the
 * uniform.
 *
 * Needs the context current and the program applied. @param texture that of the batch; null where it has none. */
void bindSurface(osg::State& state, const GridBatch& batch, osg::Texture2D* texture);

} // namespace osgLego
