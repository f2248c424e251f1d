// Ambient occlusion, the first pass: resolves the geometry buffer to one depth per pixel, in eye coordinates, and its node and
// coverage (pixel_contents.glsl). With several samples (SAMPLES above 1), depth and normals come from the first covered
// sample, which is at nearly the same position in each pixel, so that neighbours are consistent; light is averaged over
// all covered samples.

#define NUM_OUTPUTS 5
#include "gl/fragment_outputs.glsl"
#include "occlusion/pixel_contents.glsl"
#include "occlusion/view_position.glsl"
#include "polygonization/geometry_buffer.glsl"

#if SAMPLES > 1

#include "light/color_space.glsl"

uniform sampler2DMS lightBuffer;
uniform sampler2DMS albedoBuffer;
uniform sampler2DMS normalBuffer;
uniform sampler2DMS depthBuffer;
uniform sampler2DMS brickOcclusion;

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
    vec4 own = texelFetch(brickOcclusion, pixel, chosen);
    float roughness = texelFetch(lightBuffer, pixel, chosen).a;
    PixelContents contents = PixelContents(numberOf(normals, roughness, own), count);
    fragmentData[0] = vec4(eyeDepthOf(depth), packContents(contents), 0.0, 0.0);
    fragmentData[1] = vec4(light / float(count), roughness);
    fragmentData[2] = albedo / float(count);
    fragmentData[3] = normals;
    fragmentData[4] = own;
}

#else

uniform sampler2D lightBuffer;
uniform sampler2D normalBuffer;
uniform sampler2D depthBuffer;
uniform sampler2D brickOcclusion;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthBuffer, pixel, 0).r;
    float alpha = texelFetch(lightBuffer, pixel, 0).a;
    // Children that write no depth, such as skies, are recognized by their colour.
    if (depth >= 1.0 && alpha == 0.0) discard;
    int number = numberOf(texelFetch(normalBuffer, pixel, 0), alpha, texelFetch(brickOcclusion, pixel, 0));
    fragmentData[0] = vec4(eyeDepthOf(depth), packContents(PixelContents(number, 1)), 0.0, 0.0);
}

#endif
