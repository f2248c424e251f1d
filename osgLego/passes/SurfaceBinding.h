#pragma once

#include <osgLego/flattening/GridTriangles.h>

#include <osg/State>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create the texture of a surface for shaders/passes/surface_color.glsl, with all its mipmaps. Needs no context. */
osg::ref_ptr<osg::Texture2D> createSurfaceTexture(const SurfaceTexture& surface);

/** Bind the texture of a batch to unit 0, and set the uniform for its environment, for
 * shaders/passes/surface_color.glsl.
 *
 * Needs the context current and the program applied. @param texture the batch's texture; null if it has none. */
void bindSurface(osg::State& state, const GridBatch& batch, osg::Texture2D* texture);

} // namespace osgLego
