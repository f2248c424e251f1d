// Splats: each brick becomes a point just large enough to cover the parts of it that may be visible. With #define DEPTH_ONLY,
// splats are drawn right into a depth buffer; with #define BACK_FACES, they show the sides turned away from the eye.

#include "gl/fixed_state.glsl"
#include "polygonization/splat_rays.glsl"
#include "osgLego/polygonization/StudVisibility.h"
#if defined(PARTIAL)
#include "polygonization/partial_bricks.glsl"
#endif

layout(location = 0) in uvec3 vertexBrick; // see BrickPoint

uniform int firstSplat;   // the number of the first brick's splat
uniform vec2 pictureSize; // pixels
uniform vec2 depth;       // at the start of a ray, and the change with the ray's parameter (in perspective: its reciprocal)

// The splat, without the part that is hit; bits for the sides (by axis, in stud coordinates) and the stud that are open and
// turned towards the eye; the height of studs. With BACK_FACES: bits for the open sides, lower and upper of each axis, and
// bit 6 for the stud.
flat out uvec3 splat;
// xyz, in stud coordinates: the changes of rays per pixel to the right and up, and the origin (relative to the cell) and
// direction of the ray at the picture's corner. w: 1 if the direction changes from pixel to pixel, 0 if the origin does; the
// slack, in cells; the depth.
flat out vec4 rays[4];
#if defined(DEPTH_ONLY)
uniform vec3 rayWeight; // see CellView::Rays
uniform vec2 depthRange;
uniform vec2 depthOffset; // for each unit of the slope, and constant

flat out vec2 offset; // likewise
flat out vec3 weight;
#endif

const float SLACK = 0.002; // pixels by which sides are extended, so that rounding leaves no cracks between bricks
const float MARGIN = 0.05; // pixels added to each side of a point, since rounding may shrink it
// Left of the picture but inside the viewport, which extends beyond the picture: clipped points are slower to process.
const vec4 NOWHERE = vec4(-0.5, 0.0, 0.0, 1.0);

struct Box
{
    vec3 lower;
    vec3 upper;
};

// For each axis, whether the side turned towards the eye is open.
bvec3 seenSides(vec3 toEye, uint open)
{
    uvec3 sides = uvec3(open, open >> 2, open >> 4);
    uvec3 turned = uvec3(lessThan(toEye, vec3(0.0))) + 2u * uvec3(greaterThan(toEye, vec3(eye.w)));
    return notEqual(sides & turned, uvec3(0u));
}

// For each axis, the open sides turned away from the eye: 1 for the lower, 2 for the upper.
uvec3 awaySides(vec3 toEye, uint open)
{
    uvec3 turned = uvec3(greaterThan(toEye, vec3(0.0))) + 2u * uvec3(lessThan(toEye, vec3(eye.w)));
    return uvec3(open, open >> 2, open >> 4) & turned;
}

bool isStudDrawn(vec3 toEye)
{
#if defined(BACK_FACES)
    return true;
#else
    vec3 fromFoot = toStud(toEye) - eye.w * vec3(0.5, 0.5, 1.0);
    return isStudSeen(length(fromFoot.xy), -fromFoot.z, studHeight, eye.w);
#endif
}

// The bounding box of the visible sides of a cell, which is flat if there is only one.
Box boxAround(bvec3 seen, vec3 toEye)
{
    if (!any(seen)) return Box(vec3(2.0), vec3(-1.0));
    bvec3 isDeep = bvec3(seen.y || seen.z, seen.x || seen.z, seen.x || seen.y);
    vec3 side = vec3(greaterThan(toEye, vec3(0.5 * eye.w)));
    return Box(mix(side, vec3(0.0), isDeep), mix(side, vec3(1.0), isDeep));
}

// The bounds of a box in the picture, from -1 to 1: its centre and an upper bound of its half extent.
vec4 pictureOf(Box box)
{
    vec3 reach = 0.5 * (box.upper - box.lower);
    vec4 middle = modelViewProjectionMatrix * vec4(box.lower + reach, 1.0);
    vec2 place = middle.xy / middle.w;
    vec2 most = vec2(0.0);
    float nearest = middle.w;
    for (int axis = 0; axis < 3; ++axis)
    {
        vec4 step = modelViewProjectionMatrix[axis];
        most += abs(step.xy - place * step.w) * reach[axis];
        nearest -= abs(step.w) * reach[axis];
    }
    return vec4(place, most / nearest);
}

// The offset and the ray's depth, converted to the depth range.
vec2 passDepth()
{
#if defined(DEPTH_ONLY)
    float size = depthRange.y - depthRange.x;
    offset = vec2(abs(size * depth.y) * depthOffset.x, depthOffset.y);
    return vec2(depthRange.x, 0.0) + size * depth;
#else
    return depth;
#endif
}

void passRays(vec3 cell)
{
    vec2 converted = passDepth();
    bool isPerspective = eye.w != 0.0;
    mat3 change = isPerspective ? rayDirection : rayOrigin;
    // The directions of rays have a length of about 1.
    float range = isPerspective ? length(eye.xyz - cell) : 1.0;
    vec3 corner = toStud(cell);
#if defined(DEPTH_ONLY)
    weight = rayWeight;
    rays[0] = vec4(change[1] - weight.y * corner, eye.w);
    rays[1] = vec4(change[2] - weight.z * corner, SLACK * range * length(change[1] - weight.y * corner));
    rays[2] = vec4(rayOrigin[0] - weight.x * corner, converted.x);
#else
    rays[0] = vec4(change[1], eye.w);
    rays[1] = vec4(change[2], SLACK * range * length(change[1]));
    rays[2] = vec4(rayOrigin[0] - corner, converted.x);
#endif
    rays[3] = vec4(rayDirection[0], converted.y);
}

void main()
{
    vec3 cell = vec3(vertexBrick.x & 0xffffu, vertexBrick.x >> 16, vertexBrick.y & 0xffffu);
    vec3 toEye = eye.xyz - eye.w * cell;
#if defined(PARTIAL)
    uint open = placedBrick(vertexBrick).y >> 16;
    uint number = uint(firstSplat + gl_VertexID) << 9 | noveltyHere() << 8 | (open & 63u) << 2;
#else
    uint open = vertexBrick.y >> 16;
    uint number = uint(firstSplat + gl_VertexID) << 2;
#endif
#if defined(BACK_FACES)
    uvec3 sides = awaySides(toEye, open);
    Box box = sides == uvec3(0u) ? Box(vec3(2.0), vec3(-1.0)) : Box(vec3(0.0), vec3(1.0));
    uvec3 bits = uvec3(1u, 4u, 16u) * uvec3(toStud(vec3(sides)));
#else
    bvec3 seen = seenSides(toEye, open);
    Box box = boxAround(seen, toEye);
    uvec3 bits = uvec3(1u, 2u, 4u) * uvec3(toStud(vec3(seen)));
#endif
    splat = uvec3(number, bits.x | bits.y | bits.z, floatBitsToUint(studHeight));
#if defined(STUDS)
    if ((open & (2u << (2 * upAxis))) != 0u && isStudDrawn(toEye))
    {
        splat.y |= STUD_BIT;
        box.lower = min(box.lower, fromStud(vec3(0.5 - STUD_RADIUS, 0.5 - STUD_RADIUS, 1.0)));
        box.upper = max(box.upper, fromStud(vec3(0.5 + STUD_RADIUS, 0.5 + STUD_RADIUS, 1.0 + studHeight)));
    }
#endif
    passRays(cell);
    vec4 picture = pictureOf(Box(cell + box.lower, cell + box.upper));
    vec2 least = max(picture.xy - picture.zw, -1.0);
    vec2 most = min(picture.xy + picture.zw, 1.0);
    vec2 extent = 0.5 * (most - least) * pictureSize;
    bool isInPicture = splat.y != 0u && all(greaterThanEqual(extent, vec2(0.0)));
    vec2 place = 0.5 * (least + most);
    gl_PointSize = isInPicture ? max(extent.x, extent.y) + 2.0 * MARGIN : 1.0;
    gl_Position = isInPicture ? vec4(0.5 + 0.5 * place.x, place.y, 0.0, 1.0) : NOWHERE;
}
