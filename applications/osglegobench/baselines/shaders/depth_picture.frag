// A picture of the grid along one of its axes: the colour of the nearest surface or, when peeling, of the nearest
// surface behind the previous layer.

noperspective in vec2 coordinate;
noperspective in vec3 color;
flat in float level;

#ifdef IS_PEELING
uniform sampler2D previousDepth;
uniform int isFirstLayer;
#endif

#include "passes/surface_color.glsl"

void main()
{
#ifdef IS_PEELING
    float previous = texelFetch(previousDepth, ivec2(gl_FragCoord.xy), 0).r;
    if (isFirstLayer == 0 && gl_FragCoord.z <= previous) discard;
#endif
    gl_FragColor = vec4(surfaceColor(color, coordinate, level), 1.0);
}
