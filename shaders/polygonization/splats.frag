// Splats: finds the brick that a pixel shows. All coordinates are stud coordinates (see splat_rays.glsl).
//
// Only the vertex shader reads uniforms: software renderers read them again for every few pixels.

#include "polygonization/splat_rays.glsl"

// See splats.vert.
flat in uvec3 splat;
flat in vec4 rays[4];

out uint nearest; // see splat_rays.glsl

const float TINY = 1e-20; // avoids divisions by 0

// In coordinates relative to the lower corner of the cell.
Ray rayHere()
{
    vec3 change = gl_FragCoord.x * rays[0].xyz + gl_FragCoord.y * rays[1].xyz;
    return Ray(rays[2].xyz + (1.0 - rays[0].w) * change, rays[3].xyz + rays[0].w * change);
}

// The parameter at which a ray hits a visible side; `part` becomes the axis of this side. NEVER if it misses.
float meetSides(Ray ray, inout uint part)
{
    vec3 steps = 1.0 / (ray.direction + TINY);
    vec3 middle = (0.5 - ray.origin) * steps;
    vec3 reach = abs(steps);
    bvec3 isSeen = notEqual(splat.yyy & uvec3(1u, 2u, 4u), uvec3(0u));
    vec3 near = mix(vec3(-NEVER), middle - 0.5 * reach, isSeen);
    float first = max(near.x, max(near.y, near.z));
    float slack = rays[1].w;
    if (any(greaterThan(abs(first - middle), (0.5 + slack) * reach))) return NEVER;
    part = near.x == first ? 0u : near.y == first ? 1u : 2u;
    return first;
}

void main()
{
    Ray ray = rayHere();
    uint part = STUD;
    float distance = meetSides(ray, part);
#if defined(STUDS)
    vec2 facet;
    float stud = (splat.y & 8u) != 0u ? meetStud(ray, uintBitsToFloat(splat.z), facet) : NEVER;
    if (stud < distance) part = STUD;
    distance = min(distance, stud);
#endif
    if (distance == NEVER) discard;
    nearest = splat.x | part;
    gl_FragDepth = rays[2].w + rays[3].w * (rays[0].w == 0.0 ? distance : 1.0 / distance);
}
