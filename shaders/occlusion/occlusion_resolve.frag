// Ambient occlusion, the first pass: resolves the geometry buffer to one depth per pixel, in eye coordinates, and the
// covered fraction of the pixel. With several samples (SAMPLES above 1), depth and normals come from the first covered
// sample, which is at nearly the same position in each pixel, so that neighbours are consistent; light is averaged over
// all covered samples.

#define NUM_OUTPUTS 5
#include "gl/fragment_outputs.glsl"
#include "occlusion/view_position.glsl"

#if SAMPLES > 1

#include "light/color_space.glsl"
#include "polygonization/geometry_buffer.glsl"

uniform sampler2DMS lightBuffer;
uniform sampler2DMS albedoBuffer;
uniform sampler2DMS normalBuffer;
uniform sampler2DMS depthBuffer;
#if defined(DISTANT_OCCLUSION)
uniform sampler2DMS distantBuffer;
#endif

// Children that write no depth, such as skies, are recognized by their colour.
bool isCovered(ivec2 pixel, int index)
{
    return texelFetch(depthBuffer, pixel, index).r < 1.0 || texelFetch(lightBuffer, pixel, index).a > 0.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = 1.0;
    int chosen = 0;
    int count = 0;
    for (int index = SAMPLES - 1; index >= 0; --index)
    {
        if (!isCovered(pixel, index)) continue;
        float sampled = texelFetch(depthBuffer, pixel, index).r;
        ++count;
        depth = sampled;
        chosen = index;
    }
    if (count == 0) discard;

    vec4 normals = texelFetch(normalBuffer, pixel, chosen);
    bool inLight = isBrick(normals);
    vec3 light = vec3(0.0);
    vec4 albedo = vec4(0.0);
    for (int index = 0; index < SAMPLES; ++index)
    {
        if (!isCovered(pixel, index)) continue;
        vec4 color = texelFetch(lightBuffer, pixel, index);
        bool isLight = isBrick(texelFetch(normalBuffer, pixel, index));
        // Display values and linear light are converted to whichever the chosen sample has.
        if (inLight && !isLight) color.rgb = toLight(color.rgb);
        if (!inLight && isLight) color.rgb = toColor(color.rgb);
        light += color.rgb;
        // Only bricks write an albedo; other children write their colour instead.
        albedo += isLight ? texelFetch(albedoBuffer, pixel, index) : vec4(0.0, 0.0, 0.0, 1.0);
    }
    fragmentData[0] = vec4(eyeDepthOf(depth), float(count) / float(SAMPLES), 0.0, 0.0);
    fragmentData[1] = vec4(light / float(count), texelFetch(lightBuffer, pixel, chosen).a);
    fragmentData[2] = albedo / float(count);
    fragmentData[3] = normals;
#if defined(DISTANT_OCCLUSION)
    fragmentData[4] = texelFetch(distantBuffer, pixel, chosen);
#endif
}

#else

uniform sampler2D lightBuffer;
uniform sampler2D depthBuffer;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthBuffer, pixel, 0).r;
    // Children that write no depth, such as skies, are recognized by their colour.
    if (depth >= 1.0 && texelFetch(lightBuffer, pixel, 0).a == 0.0) discard;
    fragmentData[0] = vec4(eyeDepthOf(depth));
}

#endif
