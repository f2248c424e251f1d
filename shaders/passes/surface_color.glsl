// The colour of a surface: its vertex colour combined with its texture, as with glTexEnv.

#include "passes/vertex_packing.glsl"

uniform sampler2D surfaceTexture;
uniform int textureEnvironment; // 0 none, 1 modulate, 2 replace, 3 decal, 4 add

vec3 surfaceColor(vec3 color, vec2 coordinate, float level)
{
    if (textureEnvironment == 0) return color;
    vec4 texel = textureLod(surfaceTexture, coordinate, level);
    if (textureEnvironment == 2) return texel.rgb;
    if (textureEnvironment == 3) return mix(color, texel.rgb, texel.a);
    if (textureEnvironment == 4) return min(color + texel.rgb, 1.0);
    return color * texel.rgb;
}
