// Polygonization (the paper, section III-C, Algorithm 5): a point becomes a brick's open sides (first invocation), and
// the wall and the disk of its stud (second), unless another brick sits on it. Everything winds counter-clockwise seen
// from outside.

layout(points, invocations = 2) in;
layout(triangle_strip, max_vertices = 50) out;

flat in uvec3 brick[];

uniform int upAxis;       // 1 or 2
uniform float studHeight; // in cells; the radius lies across, where a cell is as wide as the pitch

out vec3 eyePosition;
out vec3 eyeNormal;
out vec2 coordinate; // faces: 0 to 1 across; disk: likewise; wall: around and up
flat out uint color;

const float STUD_RADIUS = 0.3;
const int STUD_SIDES = 16;

void emitVertex(vec3 position, vec3 normal, vec2 place)
{
    vec4 eye = gl_ModelViewMatrix * vec4(position, 1.0);
    eyePosition = eye.xyz;
    eyeNormal = gl_NormalMatrix * normal;
    coordinate = place;
    color = brick[0].z;
    gl_Position = gl_ProjectionMatrix * eye;
    EmitVertex();
}

void emitSide(vec3 cell, int axis, bool upper)
{
    vec3 normal = vec3(0.0);
    normal[axis] = upper ? 1.0 : -1.0;
    vec3 corner = cell;
    if (upper) corner[axis] += 1.0;
    vec3 u = vec3(0.0);
    vec3 v = vec3(0.0);
    u[(axis + (upper ? 1 : 2)) % 3] = 1.0;
    v[(axis + (upper ? 2 : 1)) % 3] = 1.0;
    emitVertex(corner, normal, vec2(0.0, 0.0));
    emitVertex(corner + u, normal, vec2(1.0, 0.0));
    emitVertex(corner + v, normal, vec2(0.0, 1.0));
    emitVertex(corner + u + v, normal, vec2(1.0, 1.0));
    EndPrimitive();
}

vec3 across(float u, float v)
{
    vec3 result = vec3(0.0);
    result[(upAxis + 1) % 3] = u;
    result[(upAxis + 2) % 3] = v;
    return result;
}

vec3 directionOf(int side)
{
    float angle = 6.28318530718 * float(side) / float(STUD_SIDES);
    return across(cos(angle), sin(angle));
}

void emitStudWall(vec3 center, vec3 up)
{
    for (int side = 0; side <= STUD_SIDES; ++side)
    {
        // The seam's two edges are the same edge, to the last digit.
        vec3 direction = directionOf(side % STUD_SIDES);
        vec3 foot = center + STUD_RADIUS * direction;
        float around = float(side) / float(STUD_SIDES);
        emitVertex(foot + up, direction, vec2(around, 1.0));
        emitVertex(foot, direction, vec2(around, 0.0));
    }
    EndPrimitive();
}

void emitStudDisk(vec3 center, vec3 normal)
{
    // A strip that zigzags across: 0, 1, 15, 2, 14 and so on.
    for (int index = 0; index < STUD_SIDES; ++index)
    {
        int side = index % 2 == 1 ? (index + 1) / 2 : (STUD_SIDES - index / 2) % STUD_SIDES;
        vec3 direction = directionOf(side);
        vec2 place = vec2(direction[(upAxis + 1) % 3], direction[(upAxis + 2) % 3]);
        emitVertex(center + STUD_RADIUS * direction, normal, 0.5 + 0.5 * place);
    }
    EndPrimitive();
}

void main()
{
    vec3 cell = vec3(brick[0].x & 0xffffu, brick[0].x >> 16, brick[0].y & 0xffffu);
    uint open = brick[0].y >> 16;
    if (gl_InvocationID == 0)
    {
        for (int side = 0; side < 6; ++side)
            if ((open & (1u << side)) != 0u) emitSide(cell, side / 2, side % 2 == 1);
    }
    else if ((open & (2u << (2 * upAxis))) != 0u)
    {
        vec3 normal = vec3(0.0);
        normal[upAxis] = 1.0;
        vec3 center = cell + across(0.5, 0.5) + normal;
        emitStudWall(center, studHeight * normal);
        emitStudDisk(center + studHeight * normal, normal);
    }
}
