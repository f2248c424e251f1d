#pragma once

#include <osgLego/LightProbe.h>

#include <osg/StateSet>

namespace osgLego
{

/** Texture units of the maps that shaders/light/ambient_light.glsl looks up; the units below are the passes' own. */
constexpr unsigned int CONVOLVED_MAP_UNIT = 6;
constexpr unsigned int REFLECTION_MAP_UNIT = 7;

/** Put what shaders/light/ambient_light.glsl needs of a probe into a state set: uniforms and two textures.
 *
 * May be called from any thread on a state set that no other thread uses. */
void applyLightProbe(const LightProbe& probe, osg::StateSet& stateSet);

} // namespace osgLego
