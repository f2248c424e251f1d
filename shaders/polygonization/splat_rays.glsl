// Intersections of the rays of pixels with bricks, for drawing without triangles: a splat is a square of pixels that encloses
// a brick's picture, and each of its pixels intersects its ray with the brick (Majercik et al. 2018, "A Ray-Box Intersection
// Algorithm and Efficient Dynamic Voxel Rendering"). Studs are prisms, as in the geometry shader.
//
// A splat is the number of its brick, and the part of it that the ray hits in the lowest two bits: the axis of a
// face in stud coordinates, whose last axis is up, or STUD. The bricks of all nodes that are drawn into the same picture have
// different numbers: a node's bricks in the order of its buffer, after those of the node before. For models drawn partly built (#define PARTIAL), 6 bits with the
// open sides of the brick and one that is set for a highlighted part are between the two.

#include "osgLego/BrickDimensions.h"

#if !defined(SPLATS) // the shading of splats takes these from splat_scene.glsl
uniform int upAxis;
uniform float studHeight;  // in cells
uniform vec4 eye;          // in cells: the position or, if w is 0, the direction towards the eye
uniform mat3 rayOrigin;    // in cells: at the picture's lower left corner, and the changes per pixel to the right and up
uniform mat3 rayDirection; // likewise
#endif

const uint STUD = 3u;
#if defined(BACK_FACES)
const uint STUD_BIT = 64u; // see splats.vert
#else
const uint STUD_BIT = 8u;
#endif
const float APOTHEM = STUD_RADIUS * 0.980785280; // the cosine of half a side's angle
// The normal of one side of each opposite pair.
const vec2 FACETS[STUD_SIDES / 2] =
    vec2[](vec2(0.980785280, 0.195090322), vec2(0.831469612, 0.555570233), vec2(0.555570233, 0.831469612),
           vec2(0.195090322, 0.980785280), vec2(-0.195090322, 0.980785280), vec2(-0.555570233, 0.831469612),
           vec2(-0.831469612, 0.555570233), vec2(-0.980785280, 0.195090322));
const float NEVER = 1e30;

struct Ray
{
    vec3 origin;
    vec3 direction;
};

// From the axes of the grid to those of a stud: two across, and its own.
vec3 toStud(vec3 vector)
{
    return upAxis == 1 ? vector.zxy : vector;
}

vec3 fromStud(vec3 vector)
{
    return upAxis == 1 ? vector.yzx : vector;
}

// Where a ray passes through the sides of the stud's prism without ends.
struct Crossing
{
    float first; // the parameters
    float last;
    vec2 entered; // the outward normals of the sides
    vec2 left;
};

// The origin is relative to the middle of the stud's foot.
Crossing crossWall(vec3 origin, vec3 direction)
{
    Crossing crossing = Crossing(-NEVER, NEVER, vec2(0.0), vec2(0.0));
    for (int index = 0; index < STUD_SIDES / 2; ++index)
    {
        // A ray parallel to a facet is treated as one that hits it far away.
        float speed = dot(FACETS[index], direction.xy);
        float slower = 1.0 / (abs(speed) < 1e-12 ? 1e-12 : speed);
        float middle = -dot(FACETS[index], origin.xy) * slower;
        float reach = APOTHEM * abs(slower);
        vec2 outward = sign(slower) * FACETS[index];
        if (middle - reach > crossing.first) crossing.entered = -outward;
        if (middle + reach < crossing.last) crossing.left = outward;
        crossing.first = max(crossing.first, middle - reach);
        crossing.last = min(crossing.last, middle + reach);
    }
    return crossing;
}

// The parameter at which a ray, in stud coordinates, hits the stud's prism; NEVER if it misses. `facet` is the normal of the
// side that it enters through, 0 for the disk.
float meetStud(Ray ray, float height, out vec2 facet)
{
    vec3 origin = ray.origin - vec3(0.5, 0.5, 1.0);
    vec3 direction = ray.direction;
    Crossing crossing = crossWall(origin, direction);
    facet = crossing.entered;
    if (crossing.first > crossing.last) return NEVER;
    float place = origin.z + crossing.first * direction.z;
    if (place >= -1e-3 && place <= height) return crossing.first;
    facet = vec2(0.0);
    float disk = (height - origin.z) / direction.z;
    return direction.z < 0.0 && disk >= crossing.first && disk <= crossing.last ? disk : NEVER;
}

// Likewise, the parameter at which a ray leaves the prism, but not through its foot. `facet` is that of the side that it leaves
// through.
float leaveStud(Ray ray, float height, out vec2 facet)
{
    vec3 origin = ray.origin - vec3(0.5, 0.5, 1.0);
    vec3 direction = ray.direction;
    Crossing crossing = crossWall(origin, direction);
    facet = crossing.left;
    if (crossing.first > crossing.last) return NEVER;
    float place = origin.z + crossing.last * direction.z;
    if (place >= -1e-3 && place <= height) return crossing.last;
    facet = vec2(0.0);
    float disk = (height - origin.z) / direction.z;
    return direction.z > 0.0 && disk >= crossing.first && disk <= crossing.last ? disk : NEVER;
}
