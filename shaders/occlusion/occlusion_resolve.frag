// Ambient occlusion, the first pass: resolves the geometry buffer to one depth per pixel, in eye coordinates, and its node and
// coverage (pixel_contents.glsl). With several samples (SAMPLES above 1), depth and normals come from the first covered
// sample, which is at nearly the same position in each pixel, so that neighbours are consistent. Light is averaged over the
// samples of that surface: with the occlusion of a surface in front, one in a dark corner behind it would shine. The
// composite takes the colour of the other samples from a neighbouring pixel that shows their surface.

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

// The greatest depth of a surface within a pixel, in pixel widths.
const float SILHOUETTE = 4.0;

// Children that write no depth, such as skies, are recognized by their colour.
bool isCovered(ivec2 pixel, int index)
{
    return texelFetch(depthBuffer, pixel, index).r < 1.0 || texelFetch(lightBuffer, pixel, index).a > 0.0;
}

// The first covered sample of a pixel, or -1.
int firstCovered(ivec2 pixel)
{
    for (int index = 0; index < SAMPLES; ++index)
        if (isCovered(pixel, index)) return index;
    return -1;
}

// True for depths in eye coordinates of different surfaces: farther apart than a surface is deep in a pixel.
bool areApart(float a, float b)
{
    return abs(a - b) > SILHOUETTE * pixelWidthAt(max(a, b));
}

// The neighbour that shows a surface of this depth; -1 if none does.
int neighborAt(ivec2 pixel, float depth)
{
    int found = -1;
    float least = 1e30;
    for (int index = 0; index < 4; ++index)
    {
        ivec2 place = clamp(pixel + NEIGHBORS[index], area.xy, area.zw);
        int first = firstCovered(place);
        if (first < 0) continue;
        float beside = eyeDepthOf(texelFetch(depthBuffer, place, first).r);
        if (areApart(depth, beside) || abs(depth - beside) >= least) continue;
        least = abs(depth - beside);
        found = index;
    }
    return found;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int chosen = firstCovered(pixel);
    if (chosen < 0) discard;
    float depth = eyeDepthOf(texelFetch(depthBuffer, pixel, chosen).r);
    vec4 normals = texelFetch(normalBuffer, pixel, chosen);

    PixelContents contents = PixelContents(0, 0, 0, 0);
    bool inLight = isBrick(normals);
    vec3 light = vec3(0.0);
    vec4 albedo = vec4(0.0);
    float beyond = 0.0;
    for (int index = 0; index < SAMPLES; ++index)
    {
        if (!isCovered(pixel, index)) continue;
        float sampled = eyeDepthOf(texelFetch(depthBuffer, pixel, index).r);
        if (areApart(depth, sampled))
        {
            beyond = sampled;
            ++contents.other;
            continue;
        }
        ++contents.covered;
        vec4 color = texelFetch(lightBuffer, pixel, index);
        bool isLight = isBrick(texelFetch(normalBuffer, pixel, index));
        // Display values and linear light are converted to whichever the chosen sample has.
        if (inLight && !isLight) color.rgb = toLight(color.rgb);
        if (!inLight && isLight) color.rgb = toColor(color.rgb);
        light += color.rgb;
        // Only bricks write an albedo; other children write their colour instead.
        albedo += isLight ? texelFetch(albedoBuffer, pixel, index) : vec4(0.0, 0.0, 0.0, 1.0);
    }
    light /= float(contents.covered);
    albedo /= float(contents.covered);
    // Without a neighbour of the same surface, all samples get the colour of the chosen one.
    int neighbor = contents.other > 0 ? neighborAt(pixel, beyond) : -1;
    if (neighbor < 0)
    {
        contents.covered += contents.other;
        contents.other = 0;
    }
    contents.neighbor = max(neighbor, 0);
    vec4 own = texelFetch(brickOcclusion, pixel, chosen);
    float roughness = texelFetch(lightBuffer, pixel, chosen).a;
    contents.number = numberOf(normals, roughness, own);
    fragmentData[0] = vec4(depth, packContents(contents), 0.0, 0.0);
    fragmentData[1] = vec4(light, roughness);
    fragmentData[2] = albedo;
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
    fragmentData[0] = vec4(eyeDepthOf(depth), packContents(PixelContents(number, 1, 0, 0)), 0.0, 0.0);
}

#endif
