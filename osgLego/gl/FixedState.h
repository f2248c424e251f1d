#pragma once

#include <osgLego/gl/ProgramUniforms.h>

#include <osg/State>

namespace osgLego
{

// These functions set uniforms of shaders/gl/fixed_state.glsl in the program that a state has applied. Those that GL
// provides in the compatibility profile are set in contexts of the core profile only (see GlRequirements::isCore()).
// The context must be current.

/** Set the matrices that the state has applied. */
void setMatrices(const ProgramUniforms& uniforms, const osg::State& state);

/** Set the mode of the applied fog, for shaders/light/fog.glsl, and its parameters. */
void setFog(const ProgramUniforms& uniforms, const osg::State& state);

/** Set the light of all scenes, and the specular reflection of the applied material. */
void setLightModelAndMaterial(const ProgramUniforms& uniforms, const osg::State& state);

} // namespace osgLego
