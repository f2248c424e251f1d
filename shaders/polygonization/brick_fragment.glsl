// The point of a brick that a fragment shows. It comes from the geometry shader or, if bricks are drawn as splats
// (#define SPLATS), from intersecting the pixel's ray with the brick again.

#include "polygonization/brick_detail.glsl"

#if defined(SPLATS)

#define PASSED flat in
#include "polygonization/splat_scene.glsl"
#define upAxis sceneNumbers.x
#define studHeight sceneRays[1].w
#define eye sceneEye
#define normalMatrix mat3(sceneNormals[0].xyz, sceneNormals[1].xyz, sceneNormals[2].xyz)
#include "polygonization/splat_rays.glsl"

uniform usampler2D splats;
uniform usamplerBuffer splatBricks; // three texels for each brick, see BrickPoint
uniform sampler2D splatDepths; // 1: no brick

vec3 eyePosition;
vec3 gridPosition; // in cells
vec3 eyeNormal;
vec2 coordinate;
vec4 coordinateSlopes; // by pixel: those of the first coordinate, those of the second
uint color;
uint detail;
int brickNumber;
const bool isOutside = true;
bool isNew = true; // whether the part is drawn in full colour

// A plane in a cell, and functions of the position that give the coordinates on it.
struct Plane
{
    vec4 equation; // the normal, and the distance from the origin
    vec4 first;
    vec4 second;
};

// In coordinates relative to the lower corner of a cell.
Ray rayThrough(vec2 pixel, vec3 cell)
{
    vec3 change = pixel.x * sceneRays[0].xyz + pixel.y * sceneRays[1].xyz;
    return Ray(sceneRays[2].xyz + (1.0 - sceneRays[0].w) * change - cell, sceneRays[3].xyz + sceneRays[0].w * change);
}

vec3 unitOf(int axis)
{
    vec3 unit = vec3(0.0);
    unit[axis] = 1.0;
    return unit;
}

vec3 meet(Plane plane, vec2 pixel, vec3 cell)
{
    Ray ray = rayThrough(pixel, cell);
    float distance = (plane.equation.w - dot(plane.equation.xyz, ray.origin)) / dot(plane.equation.xyz, ray.direction);
    return ray.origin + distance * ray.direction;
}

vec2 coordinateOn(Plane plane, vec3 place)
{
    return vec2(dot(plane.first, vec4(place, 1.0)), dot(plane.second, vec4(place, 1.0)));
}

Plane planeOfFace(int axis, bool upper)
{
    ivec2 axes = axesOf(axis, upper);
    return Plane(vec4(unitOf(axis), upper ? 1.0 : 0.0), vec4(unitOf(axes.x), 0.0), vec4(unitOf(axes.y), 0.0));
}

Plane planeOfDisk()
{
    float scale = 0.5 / STUD_RADIUS;
    float offset = 0.5 - 0.5 * scale;
    return Plane(vec4(unitOf(upAxis), 1.0 + studHeight), vec4(scale * fromStud(vec3(1.0, 0.0, 0.0)), offset),
                 vec4(scale * fromStud(vec3(0.0, 1.0, 0.0)), offset));
}

Plane planeOfWall(vec2 facet)
{
    // The coordinate increases by 1 / STUD_SIDES across the width of a side.
    float scale = 1.0 / float(STUD_SIDES) / (2.0 * FACETS[0].y * STUD_RADIUS);
    return Plane(vec4(fromStud(vec3(facet, 0.0)), APOTHEM + 0.5 * (facet.x + facet.y)),
                 vec4(scale * fromStud(vec3(-facet.y, facet.x, 0.0)), 0.0),
                 vec4(unitOf(upAxis) / studHeight, -1.0 / studHeight));
}

// Find the point that the pixel shows. Returns false if there is none.
bool findFragment()
{
    vec2 origin = vec2(sceneNumbers.yz);
    vec2 pixel = gl_FragCoord.xy - origin;
    // A tile is larger than a very small picture.
    if (any(lessThan(pixel, vec2(0.0))) || pixel.x > sceneNormals[0].w || pixel.y > sceneNormals[1].w) return false;
    float depth = texelFetch(splatDepths, ivec2(pixel), 0).x;
    if (depth == 1.0) return false;
    gl_FragDepth = sceneRays[2].w + sceneRays[3].w * depth;
    uint splat = texelFetch(splats, ivec2(pixel), 0).x;
#if defined(PARTIAL)
    int number = int(splat >> 9) - sceneSplats.x;
#else
    int number = int(splat >> 2) - sceneSplats.x;
#endif
    if (number < 0 || number >= sceneSplats.y) return false; // the brick of another node
    brickNumber = number;
    int word = 3 * number;
    uvec3 brick = uvec3(texelFetch(splatBricks, word).x, texelFetch(splatBricks, word + 1).x,
                        texelFetch(splatBricks, word + 2).x);
#if defined(PARTIAL)
    brick.y = (brick.y & ~(63u << 16)) | (splat >> 2 & 63u) << 16;
    isNew = (splat >> 8 & 1u) != 0u;
#endif
    vec3 cell = vec3(brick.x & 0xffffu, brick.x >> 16, brick.y & 0xffffu);

    Plane plane;
    vec3 normal;
    if ((splat & 3u) == STUD)
    {
        vec2 facet;
        Ray ray = rayThrough(pixel, cell);
        meetStud(Ray(toStud(ray.origin), toStud(ray.direction)), studHeight, facet);
        bool isDisk = facet == vec2(0.0);
        plane = isDisk ? planeOfDisk() : planeOfWall(facet);
        vec3 place = toStud(meet(plane, pixel, cell));
        normal = isDisk ? unitOf(upAxis) : fromStud(vec3(place.xy - 0.5, 0.0));
        color = brick.z;
        detail = detailOf(brick, isDisk ? STUD_DISK : STUD_WALL, upAxis, true);
    }
    else
    {
        int axis = (int(splat & 3u) + upAxis + 1) % 3;
        bool upper = eye[axis] > (cell[axis] + 0.5) * eye.w;
        plane = planeOfFace(axis, upper);
        normal = upper ? unitOf(axis) : -unitOf(axis);
        color = colorOf(brick, axis, upper, upAxis);
        detail = detailOf(brick, FACE, axis, upper);
    }
    vec3 place = meet(plane, pixel, cell);
    coordinate = coordinateOn(plane, place);
    // Differences within a block of 2 x 2 pixels, as with dFdx and dFdy.
    vec2 first = floor(0.5 * gl_FragCoord.xy) * 2.0 + 0.5 - origin;
    vec2 base = coordinateOn(plane, meet(plane, first, cell));
    vec2 right = coordinateOn(plane, meet(plane, first + vec2(1.0, 0.0), cell)) - base;
    vec2 above = coordinateOn(plane, meet(plane, first + vec2(0.0, 1.0), cell)) - base;
    coordinateSlopes = vec4(right.x, above.x, right.y, above.y);
    gridPosition = cell + place;
    vec4 position = vec4(gridPosition, 1.0);
    eyePosition = vec3(dot(sceneRows[0], position), dot(sceneRows[1], position), dot(sceneRows[2], position));
    eyeNormal = normalMatrix * normal;
    return true;
}

#else

in vec3 eyePosition;
in vec3 eyeNormal;
in vec2 coordinate;
flat in uint color;
flat in uint detail;
#if defined(GRID_OCCLUSION)
flat in int brickNumber;
#endif
#if defined(PARTIAL)
flat in uint novelty;
#define isNew (novelty != 0u)
#else
const bool isNew = true;
#endif

#include "gl/fixed_state.glsl"

#define normalMatrix eyeNormalMatrix
// gl_FrontFacing can't be used: in wireframe mode, llvmpipe draws lines all over the window if a fragment shader that
// follows a geometry shader reads it.
#define isOutside ((detail & INSIDE) == 0u)
#define coordinateSlopes vec4(dFdx(coordinate.x), dFdy(coordinate.x), dFdx(coordinate.y), dFdy(coordinate.y))

bool findFragment()
{
    return true;
}

#endif
