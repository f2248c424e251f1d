// Ambient occlusion, the main pass: the fraction of the sky visible from each pixel, and its mean direction, the bent normal.
// It finds horizons in slices through the view direction (Jimenez et al. 2016, "Practical Realtime Strategies for
// Accurate Indirect Occlusion"), and the light between them is integrated in closed form.

#include "gl/fragment_outputs.glsl"
#include "occlusion/pixel_contents.glsl"
#include "occlusion/view_position.glsl"
#include "polygonization/geometry_buffer.glsl"

uniform sampler2D normalBuffer;
uniform sampler2D depthImage; // z in eye coordinates, and pixel_contents.glsl
uniform sampler2D noise;      // two evenly distributed numbers per pixel, from 0 to 1
uniform float radius;         // greatest distance of occluders, in units of eye coordinates
uniform float falloff;        // the outer part of the radius, over which occlusion fades out

const float PI = 3.14159265;
// The minimum radius in pixels: if bricks are smaller than pixels, occlusion comes from the shape of many bricks together.
const float LEAST_RADIUS = 8.0;

// Positions in eye coordinates, xy = slope(pixel) * z + offset(pixel), where both are linear functions of the pixel. The
// positions are those of eyePositionOf, which would read uniforms and divide again for each of the many samples of a pixel.
struct Unprojection
{
    vec4 slope;  // xy + pixel * zw
    vec4 offset; // xy + pixel * zw
};

Unprojection createUnprojection()
{
    vec2 scale = 1.0 / vec2(sceneProjection[0][0], sceneProjection[1][1]);
    vec2 middle = 0.5 * pixelSize - 1.0; // of the lowest pixel
    vec2 toSlope = scale * sceneProjection[2][3];
    vec2 toOffset = scale * sceneProjection[3][3];
    return Unprojection(vec4(middle * toSlope - scale * sceneProjection[2].xy, pixelSize * toSlope),
                        vec4(middle * toOffset - scale * sceneProjection[3].xy, pixelSize * toOffset));
}

vec3 unproject(Unprojection unprojection, ivec2 pixel, float depth)
{
    vec2 place = vec2(pixel);
    return vec3((unprojection.slope.xy + place * unprojection.slope.zw) * depth + unprojection.offset.xy +
                    place * unprojection.offset.zw,
                depth);
}

// A surface that may occlude: its position in eye coordinates, and the number of its node.
struct Occluder
{
    vec3 position;
    int number;
};

Occluder occluderAt(Unprojection unprojection, ivec2 pixel)
{
    vec2 texel = texelFetch(depthImage, clamp(pixel, area.xy, area.zw), 0).rg;
    return Occluder(unproject(unprojection, pixel, texel.r), unpackContents(texel.g).number);
}

vec3 positionAt(Unprojection unprojection, ivec2 pixel)
{
    return occluderAt(unprojection, pixel).position;
}

// The normal of a surface that wrote none. In each direction it uses the neighbour that is nearer in depth.
vec3 normalFromDepth(Unprojection unprojection, ivec2 pixel, vec3 here)
{
    vec3 right = positionAt(unprojection, pixel + ivec2(1, 0)) - here;
    vec3 left = here - positionAt(unprojection, pixel - ivec2(1, 0));
    vec3 upper = positionAt(unprojection, pixel + ivec2(0, 1)) - here;
    vec3 lower = here - positionAt(unprojection, pixel - ivec2(0, 1));
    vec3 u = abs(right.z) < abs(left.z) ? right : left;
    vec3 v = abs(upper.z) < abs(lower.z) ? upper : lower;
    return normalize(cross(u, v));
}

// A slice through the view direction.
struct Slice
{
    float cosNormal; // of the angle from the view direction to the normal
    float sinNormal;
    vec3 axis; // at right angles to the slice
    vec3 back; // in the plane of the surface, back to the slice for each unit along the axis
};

// The integrals of light from the view direction to an angle in a slice: the visible light, and its mean direction along the
// slice and towards the eye. In terms of the normal's angle n, the first is
// (cos(n) + 2 angle sin(n) - cos(2 angle - n)) / 4.
vec3 lightTo(float cosine, float sign, Slice slice)
{
    // With x = |cosine|, both acos(x) and sqrt(1 - x * x) are sqrt(1 - x) times a smooth function (for acos: Abramowitz and
    // Stegun 1964, 4.4.45). The errors are below 1e-4.
    float x = abs(cosine);
    float root = sqrt(max(1.0 - x, 0.0));
    float acute = root * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
    float angle = sign * (cosine < 0.0 ? PI - acute : acute);
    float sine = sign * root * (1.0 + x * (0.4979 + x * (-0.1137 + x * 0.0300)));
    vec2 twice = vec2(2.0 * cosine * cosine - 1.0, 2.0 * sine * cosine);
    vec2 thrice = vec2(cosine * (4.0 * cosine * cosine - 3.0), sine * (3.0 - 4.0 * sine * sine));
    float c = slice.cosNormal;
    float s = slice.sinNormal;
    return vec3(0.25 * (c + 2.0 * angle * s - twice.x * c - twice.y * s),
                vec2(3.0 * sine * c - 9.0 * cosine * s - thrice.y * c + thrice.x * s + 8.0 * s,
                     c * (4.0 - thrice.x - 3.0 * cosine) + s * (3.0 * sine - thrice.y)) /
                    12.0);
}

// One side of a slice: the horizon found so far, as a cosine, the light up to it, and the light that is left.
struct Side
{
    float horizon;
    vec3 below;
    vec3 light;
};

Side openSide(float sign, Slice slice)
{
    // At a right angle to the normal.
    float horizon = -sign * slice.sinNormal;
    vec3 light = lightTo(horizon, sign, slice);
    return Side(horizon, light, light);
}

// Raise the horizon to a surface, if that is higher. The light that it hides in addition to nearer surfaces is weighted by its
// nearness. `fade` gives the weight: fade.x + fade.y * distance.
void raise(inout Side side, float sign, vec3 step, vec3 toEye, Slice slice, vec2 fade)
{
    // Pixels are next to the slice, not exactly in it. A pixel of the same plane must stay in the plane.
    step -= dot(step, slice.axis) * slice.back;
    float square = max(dot(step, step), 1e-18);
    float inverse = inversesqrt(square);
    float cosine = dot(step, toEye) * inverse;
    float weight = min(fade.x + fade.y * square * inverse, 1.0);
    if (cosine <= side.horizon || weight <= 0.0) return;
    vec3 below = lightTo(cosine, sign, slice);
    side.light -= weight * (side.below - below);
    side.below = below;
    side.horizon = cosine;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthImage, pixel, 0).r;
    if (depth < NOTHING) discard;
    vec4 normals = texelFetch(normalBuffer, pixel, 0);
    int number = unpackContents(texelFetch(depthImage, pixel, 0).g).number;
    if (number == ALONE)
    {
        fragmentColor = vec4(surfaceNormalOf(normals), 1.0);
        return;
    }

    int own = number > 0 ? number : -1;

    Unprojection unprojection = createUnprojection();
    vec3 here = unproject(unprojection, pixel, depth);
    vec3 toEye = towardsEyeFrom(here);
    vec3 normal = isBrick(normals) ? surfaceNormalOf(normals) : normalFromDepth(unprojection, pixel, here);
    float radiusHere = max(radius, LEAST_RADIUS * pixelWidthAt(depth));
    vec2 fade = vec2(1.0, -1.0 / radiusHere) / falloff;
    vec2 reach = radiusHere / (spreadAt(depth) * pixelSize) * vec2(sceneProjection[0][0], sceneProjection[1][1]);
    vec2 random = texelFetch(noise, pixel & 63, 0).rg;

    float visibility = 0.0;
    vec3 bent = vec3(0.0);
    for (int index = 0; index < SLICES; ++index)
    {
        float angle = (float(index) + random.x) * PI / float(SLICES);
        vec3 direction = vec3(cos(angle), sin(angle), 0.0);
        vec3 tangent = normalize(direction - dot(direction, toEye) * toEye);
        vec3 axis = cross(tangent, toEye);
        vec3 projected = normal - dot(normal, axis) * axis;
        float size = max(length(projected), 1e-9);
        float along = dot(axis, normal);
        vec3 back = (axis - along * normal) / max(1.0 - along * along, 0.01);
        // Surfaces face the eye, although normals from depth may not.
        vec2 turned = vec2(dot(projected, toEye), dot(projected, tangent)) / size;
        if (turned.x < 0.0) turned = vec2(0.0, sign(turned.y));
        Slice slice = Slice(turned.x, turned.y, axis, back);

        Side ahead = openSide(1.0, slice);
        Side behind = openSide(-1.0, slice);
        for (int place = 0; place < STEPS; ++place)
        {
            float along = (float(place) + fract(random.y + 0.618034 * float(index))) / float(STEPS);
            vec2 distances = max(along * sqrt(along) * abs(reach), vec2(1.0));
            ivec2 offset = ivec2(round(direction.xy * distances * sign(reach)));
            Occluder first = occluderAt(unprojection, pixel + offset);
            Occluder second = occluderAt(unprojection, pixel - offset);
            // The occlusion by bricks of the same node is known.
            if (first.number != own) raise(ahead, 1.0, first.position - here, toEye, slice, fade);
            if (second.number != own) raise(behind, -1.0, second.position - here, toEye, slice, fade);
        }
        vec3 light = size * (ahead.light + behind.light);
        visibility += light.x;
        bent += light.y * tangent + light.z * toEye;
    }
    // With few slices both values are inexact (visibility can exceed 1); only the mean over neighbours is right.
    fragmentColor = vec4(bent, visibility) / float(SLICES);
}
