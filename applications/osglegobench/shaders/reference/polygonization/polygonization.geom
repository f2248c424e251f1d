// Polygonization (the paper, section III-C, Algorithm 5): the first invocation turns a point into the open sides of a
// brick and the disk of its stud, unless another brick is on top, the second into the wall of the stud. All faces wind
// counter-clockwise as seen from outside.

layout(points, invocations = 2) in;
layout(triangle_strip, max_vertices = 40) out;

flat in uvec3 brick[];

uniform int upAxis;       // 1 or 2
uniform float studHeight; // in cells; the radius needs no scale, since a cell is as wide as the pitch

out vec3 eyePosition;
out vec3 eyeNormal;
out vec2 coordinate; // faces and disk: 0 to 1 across; wall: 0 to 1 around and up
flat out uint color;
flat out uint detail; // see detailOf()

const uint FACE = 0u;
const uint STUD_WALL = 1u;
const uint STUD_DISK = 2u;

const float STUD_RADIUS = 0.3;
const int STUD_SIDES = 16;
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
    vec4 eye = gl_ModelViewMatrix * position;
    return Place(eye.xyz, gl_ProjectionMatrix * eye);
}

Place moved(Place place, float distance, Place step)
{
    return Place(place.eye + distance * step.eye, place.clip + distance * step.clip);
}

// Pack the details that joints and variation need: the part (2 bits), the axis of a face (2), whether the face is the upper
// one on this axis (1), which of the four cells beside it are occupied (4), and a pseudo-random number of the brick (16).
uint detailOf(uint part, int axis, bool upper, uint filled)
{
    uint number = brick[0].x * 0x9e3779b1u ^ (brick[0].y & 0xffffu) * 0x85ebca77u;
    number = (number ^ number >> 15) * 0x2c1b3c6du;
    return part | uint(axis) << 2 | uint(upper) << 4 | filled << 5 | (number ^ number >> 12) << 16;
}

void emitVertex(Place place, vec3 normal, vec2 where, uint details)
{
    eyePosition = place.eye;
    eyeNormal = normal;
    coordinate = where;
    color = brick[0].z;
    detail = details;
    gl_Position = place.clip;
    gl_ClipVertex = vec4(place.eye, 1.0);
    EmitVertex();
}

void emitSide(vec3 cell, int axis, bool upper, uint open)
{
    vec3 normal = vec3(0.0);
    normal[axis] = upper ? 1.0 : -1.0;
    vec3 corner = cell;
    if (upper) corner[axis] += 1.0;
    vec4 u = vec4(0.0);
    vec4 v = vec4(0.0);
    int axisU = (axis + (upper ? 1 : 2)) % 3;
    int axisV = (axis + (upper ? 2 : 1)) % 3;
    u[axisU] = 1.0;
    v[axisV] = 1.0;
    uint details =
        detailOf(FACE, axis, upper, ~(open >> (2 * axisU)) & 3u | (~(open >> (2 * axisV)) & 3u) << 2);
    Place first = placeOf(vec4(corner, 1.0));
    Place alongU = placeOf(u);
    Place second = moved(first, 1.0, placeOf(v));
    vec3 eyeNormal = gl_NormalMatrix * normal;
    emitVertex(first, eyeNormal, vec2(0.0, 0.0), details);
    emitVertex(moved(first, 1.0, alongU), eyeNormal, vec2(1.0, 0.0), details);
    emitVertex(second, eyeNormal, vec2(0.0, 1.0), details);
    emitVertex(moved(second, 1.0, alongU), eyeNormal, vec2(1.0, 1.0), details);
    EndPrimitive();
}

vec3 across(float u, float v)
{
    vec3 result = vec3(0.0);
    result[(upAxis + 1) % 3] = u;
    result[(upAxis + 2) % 3] = v;
    return result;
}

void emitWall(vec3 center, vec3 up)
{
    Place foot = placeOf(vec4(center, 1.0));
    Place top = moved(foot, studHeight, placeOf(vec4(up, 0.0)));
    Place stepU = placeOf(vec4(across(STUD_RADIUS, 0.0), 0.0));
    Place stepV = placeOf(vec4(across(0.0, STUD_RADIUS), 0.0));
    vec3 normalU = gl_NormalMatrix * across(1.0, 0.0);
    vec3 normalV = gl_NormalMatrix * across(0.0, 1.0);
    uint wall = detailOf(STUD_WALL, upAxis, true, 0u);
    for (int side = 0; side <= STUD_SIDES; ++side)
    {
        // The first and the last edge are exactly the same.
        vec2 direction = DIRECTIONS[side % STUD_SIDES];
        vec3 normal = direction.x * normalU + direction.y * normalV;
        float around = float(side) / float(STUD_SIDES);
        emitVertex(moved(moved(top, direction.x, stepU), direction.y, stepV), normal, vec2(around, 1.0), wall);
        emitVertex(moved(moved(foot, direction.x, stepU), direction.y, stepV), normal, vec2(around, 0.0), wall);
    }
    EndPrimitive();
}

void emitDisk(vec3 center, vec3 up)
{
    Place top = moved(placeOf(vec4(center, 1.0)), studHeight, placeOf(vec4(up, 0.0)));
    Place stepU = placeOf(vec4(across(STUD_RADIUS, 0.0), 0.0));
    Place stepV = placeOf(vec4(across(0.0, STUD_RADIUS), 0.0));
    vec3 normal = gl_NormalMatrix * up;
    uint disk = detailOf(STUD_DISK, upAxis, true, 0u);
    // A strip that zigzags across the disk: 0, 1, 15, 2, 14 and so on.
    for (int index = 0; index < STUD_SIDES; ++index)
    {
        int side = index % 2 == 1 ? (index + 1) / 2 : (STUD_SIDES - index / 2) % STUD_SIDES;
        vec2 direction = DIRECTIONS[side];
        emitVertex(moved(moved(top, direction.x, stepU), direction.y, stepV), normal, 0.5 + 0.5 * direction, disk);
    }
    EndPrimitive();
}

void main()
{
    vec3 cell = vec3(brick[0].x & 0xffffu, brick[0].x >> 16, brick[0].y & 0xffffu);
    uint open = brick[0].y >> 16;
    for (int side = 0; gl_InvocationID == 0 && side < 6; ++side)
        if ((open & (1u << side)) != 0u) emitSide(cell, side / 2, side % 2 == 1, open);
    if ((open & (2u << (2 * upAxis))) == 0u) return;
    vec3 up = vec3(0.0);
    up[upAxis] = 1.0;
    vec3 center = cell + across(0.5, 0.5) + up;
    if (gl_InvocationID == 0)
        emitDisk(center, up);
    else
        emitWall(center, up);
}
