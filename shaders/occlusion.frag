// Ambient occlusion, the main pass: how much of the sky each pixel sees, and the mean direction of it, the bent normal.
// Horizons are looked for in slices through the eye's direction (Jimenez et al. 2016, "Practical Realtime Strategies for
// Accurate Indirect Occlusion"), and the light between them is integrated in closed form.

#include "view_position.glsl"
#include "geometry_buffer.glsl"

uniform sampler2D normalBuffer;
uniform sampler2D depthImage; // eye's z, coverage
uniform sampler2D noise;      // two numbers from 0 to 1 a pixel, spread evenly
uniform float radius;         // in the eye's units, how far away things occlude
uniform float falloff;        // the part of the radius over which they come to do so

const float PI = 3.14159265;

float depthAt(ivec2 pixel)
{
    return texelFetch(depthImage, clamp(pixel, ivec2(0), textureSize(depthImage, 0) - 1), 0).r;
}

vec3 positionAt(ivec2 pixel)
{
    return eyePositionOf(vec2(pixel) + 0.5, depthAt(pixel));
}

// For what wrote no normal: of the two neighbours along each direction, the nearer in depth.
vec3 normalFromDepth(ivec2 pixel, vec3 here)
{
    vec3 right = positionAt(pixel + ivec2(1, 0)) - here;
    vec3 left = here - positionAt(pixel - ivec2(1, 0));
    vec3 upper = positionAt(pixel + ivec2(0, 1)) - here;
    vec3 lower = here - positionAt(pixel - ivec2(0, 1));
    vec3 u = abs(right.z) < abs(left.z) ? right : left;
    vec3 v = abs(upper.z) < abs(lower.z) ? upper : lower;
    return normalize(cross(u, v));
}

// The cosine of the horizon that a pixel makes, sunk towards none as it is far away.
float horizonOf(vec3 position, vec3 here, vec3 toEye, float none)
{
    vec3 step = position - here;
    float range = length(step);
    float weight = clamp((radius - range) / (radius * falloff), 0.0, 1.0);
    return mix(none, dot(step, toEye) / max(range, 1e-9), weight);
}

// The integrals of light between the direction to the eye and a horizon, n the normal's angle in the slice.
float visibilityTo(float horizon, float n)
{
    return 0.25 * (cos(n) + 2.0 * horizon * sin(n) - cos(2.0 * horizon - n));
}

vec2 meanDirectionTo(float horizon, float n) // along the slice, towards the eye
{
    return vec2(6.0 * sin(horizon - n) - sin(3.0 * horizon - n) - 3.0 * sin(horizon + n) + 8.0 * sin(n),
                4.0 * cos(n) - cos(3.0 * horizon - n) - 3.0 * cos(horizon + n)) /
           12.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthImage, pixel, 0).r;
    vec4 normals = texelFetch(normalBuffer, pixel, 0);
    if (depth < NOTHING) discard;

    vec3 here = eyePositionOf(vec2(pixel) + 0.5, depth);
    vec3 toEye = towardsEyeFrom(here);
    vec3 normal = isBrick(normals) ? surfaceNormalOf(normals) : normalFromDepth(pixel, here);
    vec2 reach = radius / (spreadAt(depth) * pixelSize) * vec2(sceneProjection[0][0], sceneProjection[1][1]);
    vec2 random = texelFetch(noise, pixel & 63, 0).rg;

    float visibility = 0.0;
    vec3 bent = vec3(0.0);
    for (int slice = 0; slice < SLICES; ++slice)
    {
        float angle = (float(slice) + random.x) * PI / float(SLICES);
        vec3 direction = vec3(cos(angle), sin(angle), 0.0);
        vec3 tangent = normalize(direction - dot(direction, toEye) * toEye);
        vec3 axis = cross(tangent, toEye);
        vec3 projected = normal - dot(normal, axis) * axis;
        float size = length(projected);
        float n = atan(dot(projected, tangent), dot(projected, toEye));

        vec2 none = vec2(cos(n + 0.5 * PI), cos(n - 0.5 * PI));
        vec2 horizon = none;
        for (int index = 0; index < STEPS; ++index)
        {
            float along = (float(index) + fract(random.y + 0.618034 * float(slice))) / float(STEPS);
            ivec2 offset = ivec2(round(direction.xy * max(along * along * reach, vec2(1.0))));
            horizon.x = max(horizon.x, horizonOf(positionAt(pixel + offset), here, toEye, none.x));
            horizon.y = max(horizon.y, horizonOf(positionAt(pixel - offset), here, toEye, none.y));
        }
        vec2 angles = vec2(acos(clamp(horizon.x, -1.0, 1.0)), -acos(clamp(horizon.y, -1.0, 1.0)));
        angles = n + clamp(angles - n, -0.5 * PI, 0.5 * PI);
        visibility += size * (visibilityTo(angles.x, n) + visibilityTo(angles.y, n));
        vec2 mean = size * (meanDirectionTo(angles.x, n) + meanDirectionTo(angles.y, n));
        bent += mean.x * tangent + mean.y * toEye;
    }
    visibility = clamp(visibility / float(SLICES), 0.0, 1.0);
    bent = dot(bent, bent) > 1e-8 ? normalize(bent) : normal;
    gl_FragColor = vec4(bent, visibility);
}
