// Splats: finds the brick that a pixel shows. All coordinates are stud coordinates (see splat_rays.glsl).
//
// Only the vertex shader reads uniforms: software renderers read them again for every few pixels.

#include "polygonization/splat_rays.glsl"

// See splats.vert.
flat in uvec3 splat;
flat in vec4 rays[4];

#if defined(DEPTH_ONLY)
#include "gl/fragment_outputs.glsl"

// See splats.vert.
flat in vec2 offset;
flat in vec3 weight;
#else
out uint nearest; // see splat_rays.glsl
#endif

const float TINY = 1e-20; // avoids divisions by 0

// The weight of the pixel's ray, see CellView::Rays.
float weightHere()
{
#if defined(DEPTH_ONLY)
    return weight.x + gl_FragCoord.x * weight.y + gl_FragCoord.y * weight.z;
#else
    return 1.0;
#endif
}

// In coordinates relative to the lower corner of the cell.
Ray rayHere()
{
    vec3 change = gl_FragCoord.x * rays[0].xyz + gl_FragCoord.y * rays[1].xyz;
    return Ray((rays[2].xyz + (1.0 - rays[0].w) * change) / weightHere(), rays[3].xyz + rays[0].w * change);
}

// For each axis, whether the side that the ray meets is drawn.
bvec3 drawnSides(Ray ray)
{
#if defined(BACK_FACES)
    uvec3 leaving = uvec3(1u, 4u, 16u) << uvec3(greaterThan(ray.direction, vec3(0.0)));
    return notEqual(splat.yyy & leaving, uvec3(0u));
#else
    return notEqual(splat.yyy & uvec3(1u, 2u, 4u), uvec3(0u));
#endif
}

// The parameter at which a ray hits a drawn side; `part` becomes the axis of this side. NEVER if it misses.
float meetSides(Ray ray, inout uint part)
{
    vec3 steps = 1.0 / (ray.direction + TINY);
    vec3 middle = (0.5 - ray.origin) * steps;
    vec3 reach = abs(steps);
    bvec3 isDrawn = drawnSides(ray);
#if defined(BACK_FACES)
    vec3 sides = mix(vec3(NEVER), middle + 0.5 * reach, isDrawn);
    float met = min(sides.x, min(sides.y, sides.z));
#else
    vec3 sides = mix(vec3(-NEVER), middle - 0.5 * reach, isDrawn);
    float met = max(sides.x, max(sides.y, sides.z));
#endif
    float slack = rays[1].w / weightHere();
    if (any(greaterThan(abs(met - middle), (0.5 + slack) * reach))) return NEVER;
    part = sides.x == met ? 0u : sides.y == met ? 1u : 2u;
    return met;
}

#if defined(STUDS)
float meetDrawnStud(Ray ray, out vec2 facet)
{
    if ((splat.y & STUD_BIT) == 0u) return NEVER;
#if defined(BACK_FACES)
    return leaveStud(ray, uintBitsToFloat(splat.z), facet);
#else
    return meetStud(ray, uintBitsToFloat(splat.z), facet);
#endif
}
#endif

float depthAt(float distance)
{
    return rays[2].w + rays[3].w * (rays[0].w == 0.0 ? distance * weightHere() : 1.0 / distance);
}

#if defined(DEPTH_ONLY)

// The depth of a face, moved as by glPolygonOffset. NEVER where a ray misses the face.
float movedDepth(Ray ray, float distance, vec3 normal)
{
    if (distance == NEVER) return NEVER;
    float place = dot(normal, ray.origin + distance * ray.direction);
    vec2 change = vec2(dot(normal, rays[0].xyz), dot(normal, rays[1].xyz)) - place * weight.yz;
    vec2 speed = change / dot(normal, ray.direction);
    float slope = max(abs(speed.x), abs(speed.y)) * (rays[0].w == 0.0 ? 1.0 : 1.0 / distance);
    return depthAt(distance) + offset.x * slope + offset.y;
}

void main()
{
    Ray ray = rayHere();
    uint part = STUD;
    float sides = meetSides(ray, part);
    float depth = movedDepth(ray, sides, vec3(equal(uvec3(part), uvec3(0u, 1u, 2u))));
#if defined(STUDS)
    // The stud is not nearer if it is moved further.
    vec2 facet;
    float stud = meetDrawnStud(ray, facet);
    depth = min(depth, movedDepth(ray, stud, facet == vec2(0.0) ? vec3(0.0, 0.0, 1.0) : vec3(facet, 0.0)));
#endif
    if (depth == NEVER) discard;
    gl_FragDepth = depth;
    fragmentColor = vec4(1.0); // opaque, for an alpha test
}

#else

void main()
{
    Ray ray = rayHere();
    uint part = STUD;
    float distance = meetSides(ray, part);
#if defined(STUDS)
    vec2 facet;
    float stud = meetDrawnStud(ray, facet);
    if (stud < distance) part = STUD;
    distance = min(distance, stud);
#endif
    if (distance == NEVER) discard;
    nearest = splat.x | part;
    gl_FragDepth = depthAt(distance);
}

#endif
