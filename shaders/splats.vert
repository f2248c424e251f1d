// Splats: each brick becomes a point as large as what may be seen of it.

#include "splat_rays.glsl"

layout(location = 0) in uvec3 vertexBrick; // x | y << 16, z | open sides << 16, colour

uniform vec2 pictureSize; // pixels

flat out uvec2 splat;
flat out uint seenSides; // by axis, those that are open and turned towards the eye; and the stud
flat out vec3 nearSides; // of the cell, on each axis the place of the one that may be seen
flat out float slack;    // by how much sides reach out, so that rounding leaves no cracks between bricks, in cells

const float SLACK = 0.002; // likewise in pixels
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
const float MARGIN = 0.05; // pixels, for what rounding may take off a point

void main()
{
    vec3 cell = vec3(vertexBrick.x & 0xffffu, vertexBrick.x >> 16, vertexBrick.y & 0xffffu);
    uint open = vertexBrick.y >> 16;
    bvec3 upper = upperSeen(cell);
    nearSides = vec3(upper);
    bool isSeen[3];
    seenSides = 0u;
    for (int axis = 0; axis < 3; ++axis)
    {
        isSeen[axis] = (open & (upper[axis] ? 2u : 1u) << (2 * axis)) != 0u &&
                       (upper[axis] ? eye[axis] > (cell[axis] + 1.0) * eye.w : eye[axis] < cell[axis] * eye.w);
        if (isSeen[axis]) seenSides |= 1u << axis;
    }
    bool hasStud = (open & (2u << (2 * upAxis))) != 0u;
    if (hasStud) seenSides |= 8u;

    // The box around all that is seen: a single side is flat.
    vec3 lower = vec3(2.0);
    vec3 higher = vec3(-1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
        if (!isSeen[axis]) continue;
        vec3 low = vec3(0.0);
        vec3 high = vec3(1.0);
        low[axis] = nearSides[axis];
        high[axis] = nearSides[axis];
        lower = min(lower, low);
        higher = max(higher, high);
    }
    if (hasStud)
    {
        lower = min(lower, fromStud(vec3(0.5 - STUD_RADIUS, 0.5 - STUD_RADIUS, 1.0)));
        higher = max(higher, fromStud(vec3(0.5 + STUD_RADIUS, 0.5 + STUD_RADIUS, 1.0 + studHeight)));
    }

    vec4 base = gl_ModelViewProjectionMatrix * vec4(cell + lower, 1.0);
    vec2 least = vec2(1e9);
    vec2 most = vec2(-1e9);
    for (int corner = 0; corner < 8; ++corner)
    {
        vec3 step = vec3(corner & 1, corner >> 1 & 1, corner >> 2) * (higher - lower);
        vec4 clip = base + gl_ModelViewProjectionMatrix * vec4(step, 0.0);
        vec2 place = clip.xy / clip.w;
        least = min(least, place);
        most = max(most, place);
    }
    least = max(least, -1.0);
    most = min(most, 1.0);
    vec2 extent = 0.5 * (most - least) * pictureSize;
    Ray ray = rayThrough(0.5 * pictureSize, cell + nearSides);
    float range = eye.w == 0.0 ? 0.0 : length(ray.origin) / length(ray.direction);
    slack = SLACK * (length(rayOrigin[1]) + range * length(rayDirection[1]));
    splat = packSplat(vertexBrick);
    gl_PointSize = max(extent.x, extent.y) + 2.0 * MARGIN;
    gl_Position = seenSides == 0u || any(lessThan(extent, vec2(0.0))) ? NOWHERE : vec4(0.5 * (least + most), 0.0, 1.0);
}
