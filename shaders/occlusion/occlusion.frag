// Ambient occlusion, the main pass: how much of the sky each pixel sees, and the mean direction of it, the bent normal.
// Horizons are looked for in slices through the eye's direction (Jimenez et al. 2016, "Practical Realtime Strategies for
// Accurate Indirect Occlusion"), and the light between them is integrated in closed form.

#include "occlusion/view_position.glsl"
#include "polygonization/geometry_buffer.glsl"

uniform sampler2D normalBuffer;
uniform sampler2D depthImage; // eye's z, coverage
uniform sampler2D noise;      // two numbers from 0 to 1 a pixel, spread evenly
uniform float radius;         // in the eye's units, how far away things occlude
uniform float falloff;        // the part of the radius over which they come to do so

const float PI = 3.14159265;
// Pixels that the radius is wide at the least: where bricks are smaller than pixels, the shape of many of them together is
// what occludes.
const float LEAST_RADIUS = 8.0;

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

// The integrals of light from the eye's direction to an angle in a slice, n being the normal's angle: what is visible, and
// its mean direction, along the slice and towards the eye.
vec3 lightTo(float angle, float n)
{
    return vec3(0.25 * (cos(n) + 2.0 * angle * sin(n) - cos(2.0 * angle - n)),
                vec2(6.0 * sin(angle - n) - sin(3.0 * angle - n) - 3.0 * sin(angle + n) + 8.0 * sin(n),
                     4.0 * cos(n) - cos(3.0 * angle - n) - 3.0 * cos(angle + n)) /
                    12.0);
}

// One side of a slice: how high the horizon has risen, and the light that is left.
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

// Let a pixel raise the horizon. What it adds to what nearer ones hide counts as much as it is near.
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
    // Of few slices neither is what it should be: some see more than all of the sky. Only the mean of neighbours is.
    gl_FragColor = vec4(bent, visibility) / float(SLICES);
}
