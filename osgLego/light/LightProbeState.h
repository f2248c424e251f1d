#pragma once

#include <osgLego/LightProbe.h>

#include <string>

#include <osg/StateSet>

namespace osgLego
{

/** The texture units of the maps in shaders/light/ambient_light.glsl; lower units are used by the passes. */
constexpr unsigned int CONVOLVED_MAP_UNIT = 6;
constexpr unsigned int REFLECTION_MAP_UNIT = 7;

/** Put the values of a probe for shaders/light/ambient_light.glsl into a state set: uniforms and two textures.
 *
 * May be called from any thread on a state set that no other thread uses. */
void applyLightProbe(const LightProbe& probe, osg::StateSet& stateSet);

/** The definitions that programs with shaders/light/ambient_light.glsl need for a probe. May be called from any thread.
 */
std::string defineLightProbe(const LightProbe& probe);

} // namespace osgLego
