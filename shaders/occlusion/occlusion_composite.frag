// Ambient occlusion, the composite: draws into the frame the irradiance along the bent normal, times visibility and albedo
// (the paper, section III-D), plus the light from the scene's lights and reflections. It writes depth, so that nodes
// drawn outside the group intersect the bricks.

#include "gl/fragment_outputs.glsl"
#include "occlusion/pixel_contents.glsl"
#include "occlusion/view_position.glsl"
#include "polygonization/geometry_buffer.glsl"
#include "light/color_space.glsl"
#include "light/ambient_light.glsl"
#include "light/fog.glsl"
#include "light/distant_light.glsl"

uniform sampler2D lightBuffer;
uniform sampler2D albedoBuffer;
uniform sampler2D normalBuffer;
uniform sampler2D depthImage; // z in eye coordinates, and pixel_contents.glsl
uniform sampler2D occlusion;
uniform sampler2D brickOcclusion; // OwnOcclusion or, of other bricks, distant occlusion
flat in ivec4 tile; // its lowest pixel, and the pixel beyond its highest

uniform ivec2 origin; // the viewport's lower left pixel
uniform float radius; // in units of eye coordinates
uniform int shown;    // 0: the picture, 1: occlusion, 2: bent normals, 3: irradiance, 4: normals

vec3 bricks(vec4 light, vec4 albedo, vec3 bent, vec3 bend, vec3 shading, float visibility, vec3 toEye)
{
    vec3 diffuse = irradianceAt(normalize(bent + bend)) * visibility * toLight(albedo.rgb);
    float roughness = abs(light.a);
    vec3 mirrored = reflectionAt(shading, toEye, roughness) *
                    reflectionVisibility(max(dot(shading, toEye), 0.0), visibility, roughness);
    return mix(fogParameters.color.rgb, toColor(light.rgb + diffuse + mirrored), albedo.a);
}

// The colour of a pixel's surface.
vec3 colorAt(ivec2 pixel)
{
    float depth = texelFetch(depthImage, pixel, 0).r;
    vec4 light = texelFetch(lightBuffer, pixel, 0);
    vec4 normals = texelFetch(normalBuffer, pixel, 0);
    vec4 bentAndVisibility = texelFetch(occlusion, pixel, 0);
    vec3 bent = bentAndVisibility.xyz;
    float visibility = bentAndVisibility.w;
    vec3 toEye = towardsEyeFrom(eyePositionOf(vec2(pixel) + 0.5, depth));

    // The colours of other children already include fog, which must not be occluded.
    float hidden = isUnlit(normals) ? 0.0 : (1.0 - visibility) * transmittanceAt(depth);
    vec3 color = light.rgb * (1.0 - hidden);
    vec3 surface = bent;
    if (isBrick(normals))
    {
        surface = surfaceNormalOf(normals);
        vec3 shading = shadingNormalOf(normals);
        // The normals of bricks as small as pixels are noise; bent normals are averages.
        float distinct = distinctnessOf(radius, depth);
        vec4 occluding = texelFetch(brickOcclusion, pixel, 0);
        if (hasOwnOcclusion(normals, light.a))
        {
            distinct = 1.0;
            OwnOcclusion own = unpackOcclusion(occluding);
            bent = own.number == ALONE ? own.bent : normalize(own.bent + bent - surface);
            visibility = own.visibility * (own.number == ALONE ? 1.0 : visibility);
        }
        else
            occludeFromAfar(unpackDistant(occluding), normalize(mix(bent, surface, distinct)), 0.0, bent, visibility);
        color = bricks(light, texelFetch(albedoBuffer, pixel, 0), bent, distinct * (shading - surface),
                       normalize(mix(bent, shading, distinct)), visibility, toEye);
    }
    if (shown == 1) color = vec3(visibility);
    if (shown == 2) color = 0.5 + 0.5 * bent;
    if (shown == 3) color = irradianceAt(bent);
    if (shown == 4) color = 0.5 + 0.5 * surface;
    return color;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - origin;
    vec2 depth = texelFetch(depthImage, pixel, 0).rg;
    if (depth.r < NOTHING || any(lessThan(pixel, tile.xy)) || any(greaterThanEqual(pixel, tile.zw))) discard;
    PixelContents contents = unpackContents(depth.g);
    // The pixel may be partly covered.
    vec4 color = vec4(colorAt(pixel), 1.0) * (float(contents.covered) / float(SAMPLES));
#if SAMPLES > 1
    // A loop, since software renderers run both branches of a condition.
    for (int other = min(contents.other, 1); other > 0; --other)
        color += vec4(colorAt(pixel + NEIGHBORS[contents.neighbor]), 1.0) * (float(contents.other) / float(SAMPLES));
#endif
    fragmentColor = color;
    // Even the farthest surface must be nearer than the cleared depth.
    gl_FragDepth = min(bufferDepthOf(depth.r), 0.9999999);
}
