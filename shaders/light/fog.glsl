// The scene's fog, as osg::Fog describes it.

#include "gl/fixed_state.glsl"

// fogMode: 0: none, 1: linear, 2: exponential, 3: exponential of the square.
#if defined(SPLATS)
#define fogMode sceneNumbers.w
#define fogColor sceneFog[0].rgb
#define fogDensity sceneFog[0].w
#define fogEnd sceneFog[1].x
#define fogScale sceneFog[1].y
#else
uniform int fogMode;
#define fogColor fogParameters.color.rgb
#define fogDensity fogParameters.density
#define fogEnd fogParameters.end
#define fogScale fogParameters.scale
#endif

// The fraction of a surface's light that passes through the fog, given the surface's depth in eye coordinates.
float transmittanceAt(float eyeDepth)
{
    float depth = abs(eyeDepth);
    float density = fogDensity * depth;
    if (fogMode == 1) return clamp((fogEnd - depth) * fogScale, 0.0, 1.0);
    if (fogMode == 2) return exp(-density);
    return fogMode == 3 ? exp(-density * density) : 1.0;
}
