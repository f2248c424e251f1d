// Splats: which brick a pixel shows.

#include "splat_rays.glsl"

flat in uvec2 splat;
flat in uint seenSides;
flat in vec3 nearSides; // of the cell, on each axis the place of the one that may be seen
flat in float slack;

out uvec2 nearest;

// How far on a ray meets a side; NEVER if it does not, or the side is not to be seen.
float meetSide(Ray ray, int axis, float place)
{
    float distance = (place - ray.origin[axis]) / ray.direction[axis];
    vec3 hit = ray.origin + distance * ray.direction;
    hit[axis] = 0.5;
    bool isHit = all(lessThanEqual(abs(hit - 0.5), vec3(0.5 + slack)));
    return isHit && (seenSides & (1u << axis)) != 0u ? distance : NEVER;
}

void main()
{
    vec3 cell = cellOf(splat);
    Ray ray = rayThrough(gl_FragCoord.xy, cell);
    float distance = NEVER;
    uint part = STUD;
    for (int axis = 0; axis < 3; ++axis)
    {
        float side = meetSide(ray, axis, nearSides[axis]);
        if (side < distance) part = uint(axis);
        distance = min(distance, side);
    }
    vec2 facet;
    float stud = (seenSides & 8u) != 0u ? meetStud(ray, facet) : NEVER;
    if (stud < distance) part = STUD;
    distance = min(distance, stud);
    if (distance == NEVER) discard;
    nearest = splat | uvec2(0u, part);
    gl_FragDepth = depthAt(cell + ray.origin + distance * ray.direction);
}
