// Ambient occlusion, the first pass: from the geometry buffer to one depth a pixel, in the eye's coordinates, and how much
// of the pixel is covered. Of several samples (#define SAMPLES) the first that is covered speaks for the pixel's shape: the
// same place in each pixel, or nearly, so that neighbours fit together; and all of them for its light.

#include "occlusion/view_position.glsl"

#if SAMPLES > 1

#include "light/color_space.glsl"
#include "polygonization/geometry_buffer.glsl"

uniform sampler2DMS lightBuffer;
uniform sampler2DMS albedoBuffer;
uniform sampler2DMS normalBuffer;
uniform sampler2DMS depthBuffer;

// What leaves no depth, as skies do, leaves its colour.
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
        // What is shown and what is light are brought to what the chosen one is.
        if (inLight && !isLight) color.rgb = toLight(color.rgb);
        if (!inLight && isLight) color.rgb = toColor(color.rgb);
        light += color.rgb;
        // Only bricks have an albedo that is of use; others wrote their colour.
        albedo += isLight ? texelFetch(albedoBuffer, pixel, index) : vec4(0.0, 0.0, 0.0, 1.0);
    }
    gl_FragData[0] = vec4(eyeDepthOf(depth), float(count) / float(SAMPLES), 0.0, 0.0);
    gl_FragData[1] = vec4(light / float(count), texelFetch(lightBuffer, pixel, chosen).a);
    gl_FragData[2] = albedo / float(count);
    gl_FragData[3] = normals;
}

#else

uniform sampler2D lightBuffer;
uniform sampler2D depthBuffer;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthBuffer, pixel, 0).r;
    // What leaves no depth, as skies do, leaves its colour.
    if (depth >= 1.0 && texelFetch(lightBuffer, pixel, 0).a == 0.0) discard;
    gl_FragData[0] = vec4(eyeDepthOf(depth), 1.0, 0.0, 0.0);
}

#endif
