// Ambient occlusion, the last pass before the composite: averages neighbours that are on the same surface.

#include "gl/fragment_outputs.glsl"
#include "occlusion/view_position.glsl"
#include "polygonization/geometry_buffer.glsl"

uniform sampler2D occlusion; // bent normal, visibility
uniform sampler2D depthImage;
uniform sampler2D normalBuffer;

uniform float radius; // in units of eye coordinates
uniform float power;  // exponent applied to visibility

// The greatest distance of a neighbour from this pixel's plane, in pixel widths at its depth.
const float THICKNESS = 2.0;
// The average is one pixel wider for every REACH pixels of the radius.
const float REACH = 30.0;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthImage, pixel, 0).r;
    if (depth < NOTHING) discard;
    vec4 normal = texelFetch(normalBuffer, pixel, 0);

    // The slope of depth across the picture: the smaller of the slopes on both sides.
    vec4 slopes = vec4(texelFetch(depthImage, min(pixel + ivec2(1, 0), area.zw), 0).r - depth,
                       depth - texelFetch(depthImage, max(pixel - ivec2(1, 0), area.xy), 0).r,
                       texelFetch(depthImage, min(pixel + ivec2(0, 1), area.zw), 0).r - depth,
                       depth - texelFetch(depthImage, max(pixel - ivec2(0, 1), area.xy), 0).r);
    vec2 slope = vec2(abs(slopes.x) < abs(slopes.y) ? slopes.x : slopes.y,
                      abs(slopes.z) < abs(slopes.w) ? slopes.z : slopes.w);
    float width = pixelWidthAt(depth);

    // The average is as wide as the noise is coarse: if the radius is many pixels wide, steps are far apart.
    float reach = radius / (width * REACH);
    float distinct = distinctnessOf(radius, depth);
    float spread = mix(0.1, 1.0 / clamp(reach * reach, 2.0, 10.0), distinct);
    float near1 = exp(-spread);
    float near2 = near1 * near1 * near1 * near1;
    float kernel[5] = float[5](near2, near1, 1.0, near1, near2);

    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x)
        {
            ivec2 other = clamp(pixel + ivec2(x, y), area.xy, area.zw);
            float otherDepth = texelFetch(depthImage, other, 0).r;
            if (otherDepth < NOTHING) continue;
            float away = abs(otherDepth - depth - dot(slope, vec2(x, y)));
            float alike = clamp(1.0 - away / (THICKNESS * width), 0.0, 1.0);
            vec4 otherNormal = texelFetch(normalBuffer, other, 0);
            vec2 turned = abs(otherNormal.xy - normal.xy);
            if (isBrick(normal) && isBrick(otherNormal)) alike *= clamp(1.0 - 4.0 * max(turned.x, turned.y), 0.0, 1.0);
            float weight = kernel[x + 2] * kernel[y + 2] * mix(1.0, alike, distinct);
            sum += weight * texelFetch(occlusion, other, 0);
            weights += weight;
        }
    float visibility = pow(clamp(sum.w / weights, 0.0, 1.0), power);
    fragmentColor = vec4(dot(sum.xyz, sum.xyz) > 1e-8 ? normalize(sum.xyz) : vec3(0.0, 0.0, 1.0), visibility);
}
