// Ambient occlusion, the main pass: the fraction of the sky visible from each pixel, and its mean direction, the bent normal.
// It finds horizons in slices through the view direction (Jimenez et al. 2016, "Practical Realtime Strategies for
// Accurate Indirect Occlusion"), and the light between them is integrated in closed form.

#include "occlusion/view_position.glsl"
#include "polygonization/geometry_buffer.glsl"

uniform sampler2D normalBuffer;
uniform sampler2D depthImage; // z in eye coordinates, coverage
uniform sampler2D noise;      // two evenly distributed numbers per pixel, from 0 to 1
uniform float radius;         // greatest distance of occluders, in units of eye coordinates
uniform float falloff;        // the outer part of the radius, over which occlusion fades out

const float PI = 3.14159265;
// The minimum radius in pixels: if bricks are smaller than pixels, occlusion comes from the shape of many bricks together.
const float LEAST_RADIUS = 8.0;

float depthAt(ivec2 pixel)
{
    return texelFetch(depthImage, clamp(pixel, ivec2(0), textureSize(depthImage, 0) - 1), 0).r;
}

vec3 positionAt(ivec2 pixel)
{
    return eyePositionOf(vec2(pixel) + 0.5, depthAt(pixel));
}

// The normal of a surface that wrote none. In each direction it uses the neighbour that is nearer in depth.
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

// The integrals of light from the view direction to an angle in a slice, where n is the angle of the normal: the visible
// light, and its mean direction along the slice and towards the eye.
vec3 lightTo(float angle, float n)
{
    return vec3(0.25 * (cos(n) + 2.0 * angle * sin(n) - cos(2.0 * angle - n)),
                vec2(6.0 * sin(angle - n) - sin(3.0 * angle - n) - 3.0 * sin(angle + n) + 8.0 * sin(n),
                     4.0 * cos(n) - cos(3.0 * angle - n) - 3.0 * cos(angle + n)) /
                    12.0);
}

// One side of a slice: the horizon found so far, and the remaining light.
struct Side
{
    float horizon;
    vec3 light;
};

Side openSide(float n, float side)
{
    float horizon = n + side * 0.5 * PI;
    return Side(horizon, lightTo(horizon, n));
}

// Raise the horizon to a pixel, if that is higher. The light that it hides in addition to nearer pixels is weighted by its
// nearness.
void raise(inout Side side, float sign, vec3 position, vec3 here, vec3 toEye, float n, float radiusHere)
{
    vec3 step = position - here;
    float range = length(step);
    float weight = clamp((radiusHere - range) / (radiusHere * falloff), 0.0, 1.0);
    float angle = sign * acos(clamp(dot(step, toEye) / max(range, 1e-9), -1.0, 1.0));
    if (sign * (side.horizon - angle) <= 0.0 || weight == 0.0) return;
    side.light -= weight * (lightTo(side.horizon, n) - lightTo(angle, n));
    side.horizon = angle;
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
    float radiusHere = max(radius, LEAST_RADIUS * pixelWidthAt(depth));
    vec2 reach = radiusHere / (spreadAt(depth) * pixelSize) * vec2(sceneProjection[0][0], sceneProjection[1][1]);
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

        Side ahead = openSide(n, 1.0);
        Side behind = openSide(n, -1.0);
        for (int index = 0; index < STEPS; ++index)
        {
            float along = (float(index) + fract(random.y + 0.618034 * float(slice))) / float(STEPS);
            vec2 distances = max(along * sqrt(along) * abs(reach), vec2(1.0));
            ivec2 offset = ivec2(round(direction.xy * distances * sign(reach)));
            raise(ahead, 1.0, positionAt(pixel + offset), here, toEye, n, radiusHere);
            raise(behind, -1.0, positionAt(pixel - offset), here, toEye, n, radiusHere);
        }
        vec3 light = size * (ahead.light + behind.light);
        visibility += light.x;
        bent += light.y * tangent + light.z * toEye;
    }
    // With few slices both values are inexact (visibility can exceed 1); only the mean over neighbours is right.
    gl_FragColor = vec4(bent, visibility) / float(SLICES);
}
