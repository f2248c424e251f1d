#pragma once

#include <osgLego/BrickStore.h>

#include <osg/State>

namespace osgLego
{

/** Binds what shaders/surface_color.glsl needs for a batch: its texture to unit 0, its environment to the uniform.
 *
 * Needs the context current and the program applied. */
void bindSurface(osg::State& state, const BrickStore& store, const GridBatch& batch);

} // namespace osgLego
