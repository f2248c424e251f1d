// The scene's fog, as osg::Fog describes it.

uniform int fogMode; // 0: none, 1: linear, 2: exponential, 3: exponential of the square

// The part of a surface's light that comes through the fog from a depth in the eye's coordinates.
float transmittanceAt(float eyeDepth)
{
    float depth = abs(eyeDepth);
    float density = gl_Fog.density * depth;
    if (fogMode == 1) return clamp((gl_Fog.end - depth) * gl_Fog.scale, 0.0, 1.0);
    if (fogMode == 2) return exp(-density);
    return fogMode == 3 ? exp(-density * density) : 1.0;
}
