// Rays of pixels through bricks, which need no triangles then: a splat is a square of pixels that a brick's picture lies
// within, and every pixel of it looks where its ray meets the brick (Majercik et al. 2018, "A Ray-Box Intersection
// Algorithm and Efficient Dynamic Voxel Rendering"). Studs are prisms of 16 sides, as the geometry shader makes them.
//
// A splat in two words: the cell, by 10, 10 and 12 bits, the last along the up axis | where the ray meets it: the axis of
// a face, or STUD (2 bits), the open sides (6), the colour (24).

uniform int upAxis;
uniform float studHeight; // in cells
uniform vec4 eye;         // in cells: a place, or, where the last is 0, the direction towards it
uniform mat3 rayOrigin;    // in cells, of the picture's lower left corner, and its change by pixels to the right and up
uniform mat3 rayDirection; // likewise

const uint STUD = 3u;
const float STUD_RADIUS = 0.3;
const float APOTHEM = 0.294235584; // the radius times the cosine of 1/32 of a turn
const vec2 FACETS[8] = vec2[](vec2(0.980785280, 0.195090322), vec2(0.831469612, 0.555570233),
                              vec2(0.555570233, 0.831469612), vec2(0.195090322, 0.980785280),
                              vec2(-0.195090322, 0.980785280), vec2(-0.555570233, 0.831469612),
                              vec2(-0.831469612, 0.555570233), vec2(-0.980785280, 0.195090322));
const float NEVER = 1e30;

struct Ray
{
    vec3 origin;
    vec3 direction;
};

// From the lower corner of a cell on.
Ray rayThrough(vec2 pixel, vec3 cell)
{
    return Ray(rayOrigin * vec3(1.0, pixel) - cell, rayDirection * vec3(1.0, pixel));
}

// On each axis whether the upper side is the one that may be seen.
bvec3 upperSeen(vec3 cell)
{
    return greaterThan(eye.xyz, (cell + 0.5) * eye.w);
}

uvec2 packSplat(uvec3 brick)
{
    uvec3 cell = uvec3(brick.x & 0xffffu, brick.x >> 16, brick.y & 0xffffu);
    uvec3 turned = upAxis == 1 ? cell.zxy : cell;
    return uvec2(turned.x | turned.y << 10 | turned.z << 20,
                 (brick.y >> 16) << 2 | (brick.z & 0xffffffu) << 8);
}

vec3 cellOf(uvec2 splat)
{
    vec3 turned = vec3(splat.x & 1023u, splat.x >> 10 & 1023u, splat.x >> 20);
    return upAxis == 1 ? turned.yzx : turned;
}

// From the axes of the grid to those across a stud, and its own.
vec3 toStud(vec3 vector)
{
    return upAxis == 1 ? vector.zxy : vector;
}

vec3 fromStud(vec3 vector)
{
    return upAxis == 1 ? vector.yzx : vector;
}

// Where a ray meets the prism of a stud: how far on; `facet` is the normal of the side it comes in by, 0 for the disk.
float meetStud(Ray ray, out vec2 facet)
{
    vec3 origin = toStud(ray.origin) - vec3(0.5, 0.5, 1.0);
    vec3 direction = toStud(ray.direction);
    float first = -NEVER;
    float last = NEVER;
    vec2 normal = vec2(0.0);
    for (int index = 0; index < 8; ++index)
    {
        // Along a facet, a ray is as good as any that meets it far away.
        float speed = dot(FACETS[index], direction.xy);
        float slower = 1.0 / (abs(speed) < 1e-12 ? 1e-12 : speed);
        float middle = -dot(FACETS[index], origin.xy) * slower;
        float reach = APOTHEM * abs(slower);
        if (middle - reach > first) normal = -sign(slower) * FACETS[index];
        first = max(first, middle - reach);
        last = min(last, middle + reach);
    }
    facet = normal;
    if (first > last) return NEVER;
    float height = origin.z + first * direction.z;
    if (height >= -1e-3 && height <= studHeight) return first;
    facet = vec2(0.0);
    float disk = (studHeight - origin.z) / direction.z;
    return direction.z < 0.0 && disk >= first && disk <= last ? disk : NEVER;
}

// Depth from 0 to 1 of a place in cells; beyond that it is cut off.
float depthAt(vec3 place)
{
    vec4 clip = gl_ModelViewProjectionMatrix * vec4(place, 1.0);
    return 0.5 + 0.5 * clip.z / clip.w;
}
