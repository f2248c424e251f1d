#pragma once

#include <osgLego/AmbientOcclusionSettings.h>

#include <algorithm>

namespace osgLego
{

/** The fraction of its ray that an occluder hides, with the falloff of AmbientOcclusionSettings.
 * @param distance of the occluder, and @param radius of occlusion, above 0, in the same unit. */
inline double fadeOcclusion(double distance, double radius)
{
    return std::clamp((radius - distance) / (radius * AmbientOcclusionSettings::FALLOFF), 0.0, 1.0);
}

} // namespace osgLego
