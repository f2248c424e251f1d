// Polygonization (the paper, section III-C, Algorithm 5): the first invocation turns a point into the open sides of a
// brick and the disk of its stud, unless another brick is on top, the second into the wall of the stud. All faces wind
// counter-clockwise as seen from outside. With #define DEPTH_ONLY, vertices are positions alone.

#include "gl/fixed_state.glsl"
#include "osgLego/polygonization/StudVisibility.h"
#include "polygonization/brick_detail.glsl"

// GL guarantees 1024 components of output for all vertices of an invocation. A vertex has up to 24 of them, since drivers turn
// gl_ClipVertex into eight distances from clip planes. NVIDIA's link programs that exceed the limit, and then draw nothing.
layout(points, invocations = 2) in;
layout(triangle_strip, max_vertices = 40) out; // for six sides and a disk: 6 * 4 + STUD_SIDES
#if defined(CLIP_PLANES)
out float gl_ClipDistance[8];
#endif

flat in uvec3 brick[];
#if defined(PARTIAL)
flat in uint vertexNovelty[];
#if !defined(DEPTH_ONLY)
flat out uint novelty;
#endif
#endif

uniform int upAxis;       // 1 or 2
uniform float studHeight; // in cells; the radius needs no scale, since a cell is as wide as the pitch
uniform vec4 eye;         // in cells: the position or, if w is 0, the direction towards the eye
uniform int drawnFaces;    // see Faces: 1, front-facing; 2, back-facing; 3, both

#if !defined(DEPTH_ONLY)
out vec3 eyePosition;
out vec3 eyeNormal;
out vec2 coordinate; // faces and disk: 0 to 1 across; wall: 0 to 1 around and up
flat out uint color;  // see colorOf in brick_detail.glsl
flat out uint detail; // see detailOf
#if defined(GRID_OCCLUSION)
flat in int vertexNumber[];
flat out int brickNumber;
#endif
#endif

// Directions around the stud, in a table, since the cosine is slow on some machines.
const vec2 DIRECTIONS[STUD_SIDES] = vec2[](
    vec2(1.0, 0.0), vec2(0.923879533, 0.382683432), vec2(0.707106781, 0.707106781), vec2(0.382683432, 0.923879533),
    vec2(0.0, 1.0), vec2(-0.382683432, 0.923879533), vec2(-0.707106781, 0.707106781), vec2(-0.923879533, 0.382683432),
    vec2(-1.0, 0.0), vec2(-0.923879533, -0.382683432), vec2(-0.707106781, -0.707106781), vec2(-0.382683432, -0.923879533),
    vec2(0.0, -1.0), vec2(0.382683432, -0.923879533), vec2(0.707106781, -0.707106781), vec2(0.923879533, -0.382683432));

// A position in eye and clip coordinates, or the difference of two positions.
struct Place
{
    vec3 eye;
    vec4 clip;
};

Place placeOf(vec4 position)
{
    vec4 eye = modelViewMatrix * position;
    return Place(eye.xyz, projectionMatrix * eye);
}

Place moved(Place place, float distance, Place step)
{
    return Place(place.eye + distance * step.eye, place.clip + distance * step.clip);
}

void emitVertex(Place place, vec3 normal, vec2 where, uint details, uint colors)
{
#if !defined(DEPTH_ONLY)
    eyePosition = place.eye;
    eyeNormal = normal;
    coordinate = where;
    color = colors;
    detail = details;
#if defined(GRID_OCCLUSION)
    brickNumber = vertexNumber[0];
#endif
#if defined(PARTIAL)
    novelty = vertexNovelty[0];
#endif
#endif
    gl_Position = place.clip;
#if !defined(OSGLEGO_CORE_PROFILE)
    gl_ClipVertex = vec4(place.eye, 1.0);
#elif defined(CLIP_PLANES)
    for (int plane = 0; plane < 8; ++plane)
        gl_ClipDistance[plane] = dot(clipPlanes[plane], vec4(place.eye, 1.0));
#endif
    EmitVertex();
}

// Whether the eye is on the outer side of a plane perpendicular to an axis of the grid.
bool isTurnedToEye(float place, int axis, bool upper)
{
    return upper ? eye[axis] > place * eye.w : eye[axis] < place * eye.w;
}

// Whether faces are drawn that are turned towards or away from the eye.
bool isDrawn(bool isTurned)
{
    return (drawnFaces & (isTurned ? 1 : 2)) != 0;
}

uint insideUnless(bool isTurned)
{
    return isTurned ? 0u : INSIDE;
}

void emitSide(vec3 cell, int axis, bool upper)
{
    vec3 normal = vec3(0.0);
    normal[axis] = upper ? 1.0 : -1.0;
    vec3 corner = cell;
    if (upper) corner[axis] += 1.0;
    vec4 u = vec4(0.0);
    vec4 v = vec4(0.0);
    ivec2 axes = axesOf(axis, upper);
    u[axes.x] = 1.0;
    v[axes.y] = 1.0;
    uint details = detailOf(brick[0], FACE, axis, upper) | insideUnless(isTurnedToEye(corner[axis], axis, upper));
    Place first = placeOf(vec4(corner, 1.0));
    Place alongU = placeOf(u);
    Place second = moved(first, 1.0, placeOf(v));
    vec3 eyeNormal = eyeNormalMatrix * normal;
    uint colors = colorOf(brick[0], axis, upper, upAxis);
    emitVertex(first, eyeNormal, vec2(0.0, 0.0), details, colors);
    emitVertex(moved(first, 1.0, alongU), eyeNormal, vec2(1.0, 0.0), details, colors);
    emitVertex(second, eyeNormal, vec2(0.0, 1.0), details, colors);
    emitVertex(moved(second, 1.0, alongU), eyeNormal, vec2(1.0, 1.0), details, colors);
    EndPrimitive();
}

vec3 across(float u, float v)
{
    vec3 result = vec3(0.0);
    result[(upAxis + 1) % 3] = u;
    result[(upAxis + 2) % 3] = v;
    return result;
}

// Whether the eye is on the outer side of one side of a stud's wall. `middle` is the centre of this side, in radii.
bool isWallSeen(vec3 center, vec2 middle)
{
    vec3 outward = across(middle.x, middle.y);
    return dot(eye.xyz - eye.w * (center + STUD_RADIUS * outward), outward) > 0.0;
}

bool isStudAtSeen(vec3 center)
{
    vec3 toEye = eye.xyz - eye.w * center;
    float below = -toEye[upAxis];
    toEye[upAxis] = 0.0;
    return isStudSeen(length(toEye), below, studHeight, eye.w);
}

// The frame of a stud: its foot, its top, and steps of its radius along both axes across it.
struct Stud
{
    Place foot;
    Place top;
    Place stepU;
    Place stepV;
};

Stud studAt(vec3 center, vec3 up)
{
    Place foot = placeOf(vec4(center, 1.0));
    return Stud(foot, moved(foot, studHeight, placeOf(vec4(up, 0.0))), placeOf(vec4(across(STUD_RADIUS, 0.0), 0.0)),
                placeOf(vec4(across(0.0, STUD_RADIUS), 0.0)));
}

Place around(Place middle, Stud stud, vec2 direction)
{
    return moved(moved(middle, direction.x, stud.stepU), direction.y, stud.stepV);
}

void emitWall(Stud stud, vec3 center)
{
    vec3 normalU = eyeNormalMatrix * across(1.0, 0.0);
    vec3 normalV = eyeNormalMatrix * across(0.0, 1.0);
    uint wall = detailOf(brick[0], STUD_WALL, upAxis, true);
    // A side of the wall is seen if its centre faces the eye. Adjacent sides share vertices; a shared vertex has the details
    // of the side that ends at it.
    bool wasSeen = false;
    bool wasTurned = true;
    for (int side = 0; side <= STUD_SIDES; ++side)
    {
        vec2 next = DIRECTIONS[(side + 1) % STUD_SIDES];
        // The first and the last edge are exactly the same.
        vec2 direction = DIRECTIONS[side % STUD_SIDES];
        bool isTurned = isWallSeen(center, 0.5 * (direction + next));
        bool isSeen = side < STUD_SIDES && isDrawn(isTurned);
        if (isSeen || wasSeen)
        {
            vec3 normal = direction.x * normalU + direction.y * normalV;
            float turn = float(side) / float(STUD_SIDES);
            uint details = wall | insideUnless(wasTurned);
            emitVertex(around(stud.top, stud, direction), normal, vec2(turn, 1.0), details, brick[0].z);
            emitVertex(around(stud.foot, stud, direction), normal, vec2(turn, 0.0), details, brick[0].z);
        }
        if (wasSeen && !isSeen) EndPrimitive();
        wasSeen = isSeen;
        wasTurned = isTurned;
    }
}

void emitDisk(Stud stud, vec3 center, vec3 up)
{
    bool isTurned = isTurnedToEye(center[upAxis] + studHeight, upAxis, true);
    if (!isDrawn(isTurned)) return;
    vec3 normal = eyeNormalMatrix * up;
    uint disk = detailOf(brick[0], STUD_DISK, upAxis, true) | insideUnless(isTurned);
    // A strip that zigzags across the disk: 0, 1, 15, 2, 14 and so on.
    for (int index = 0; index < STUD_SIDES; ++index)
    {
        int side = index % 2 == 1 ? (index + 1) / 2 : (STUD_SIDES - index / 2) % STUD_SIDES;
        vec2 direction = DIRECTIONS[side];
        emitVertex(around(stud.top, stud, direction), normal, 0.5 + 0.5 * direction, disk, brick[0].z);
    }
    EndPrimitive();
}

void emitSides(vec3 cell, uint open)
{
    for (int side = 0; side < 6; ++side)
    {
        int axis = side / 2;
        bool upper = side % 2 == 1;
        if ((open & (1u << side)) == 0u) continue;
        if (isDrawn(isTurnedToEye(cell[axis] + float(upper), axis, upper))) emitSide(cell, axis, upper);
    }
}

void main()
{
    vec3 cell = vec3(brick[0].x & 0xffffu, brick[0].x >> 16, brick[0].y & 0xffffu);
    uint open = brick[0].y >> 16;
    if (gl_InvocationID == 0) emitSides(cell, open);
    if ((open & (2u << (2 * upAxis))) == 0u) return;
    vec3 up = vec3(0.0);
    up[upAxis] = 1.0;
    vec3 center = cell + across(0.5, 0.5) + up;
    if (!isDrawn(false) && !isStudAtSeen(center)) return;
    Stud stud = studAt(center, up);
    if (gl_InvocationID == 0)
        emitDisk(stud, center, up);
    else
        emitWall(stud, center);
}
