// Ambient occlusion, after resolving: finds the tiles of the picture that show something.

#include "gl/fragment_outputs.glsl"
#include "occlusion/view_position.glsl"

uniform sampler2D depthImage; // z in eye coordinates

void main()
{
    ivec2 lowest = TILE * ivec2(gl_FragCoord.xy);
    ivec2 begin = max(lowest, area.xy);
    ivec2 end = min(lowest + TILE, area.zw + 1);
    float nearest = 2.0 * NOTHING;
    for (int y = begin.y; y < end.y && nearest < NOTHING; ++y)
        for (int x = begin.x; x < end.x; ++x)
            nearest = max(nearest, texelFetch(depthImage, ivec2(x, y), 0).r);
    fragmentColor = vec4(nearest < NOTHING ? 0.0 : 1.0);
}
