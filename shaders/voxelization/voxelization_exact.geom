// Exact voxelization: a fine triangle emits a point for each cell that it overlaps.
//
// The test is Akenine-Moller's (Fast 3D Triangle-Box Overlap Testing, 2001) with half-open cells: a cell holds its
// lower faces and not its upper ones. TriangleOverlap is the same on the CPU, in double precision.

layout(triangles) in;
// As many as an edge of the longest length allowed may meet, along all three axes.
layout(points, max_vertices = MAXIMUM_CELLS) out;

in vec3 position[];
flat in uint triangle[];

flat out float weight;        // the fine triangle's area inside the cell
flat out uint sourceTriangle; // the triangle that it was cut from
flat out uvec2 packedCell;    // x | y << 16, z; finding it by the texel would take divisions

#include "passes/addressing.glsl"

// In cells squared: lets a triangle that only grazes a cell decide its colour when no other covers it.
const float LEAST_WEIGHT = 1e-9;

// An axis in a coordinate plane: a cell is apart when its corner's place on the axis leaves the bounds, or is one of
// them that is open.
struct PlaneAxis
{
    vec2 direction;
    float lower;
    float upper;
    bool lowerIsOpen;
    bool upperIsOpen;
};

PlaneAxis planeAxis(vec2 edge, vec2 a, vec2 b, vec2 c)
{
    vec2 direction = vec2(-edge.y, edge.x);
    vec3 places = vec3(dot(direction, a), dot(direction, b), dot(direction, c));
    vec2 upward = max(direction, 0.0);
    vec2 downward = min(direction, 0.0);
    return PlaneAxis(direction, min(places.x, min(places.y, places.z)) - (upward.x + upward.y),
                     max(places.x, max(places.y, places.z)) - (downward.x + downward.y),
                     any(greaterThan(direction, vec2(0.0))), any(lessThan(direction, vec2(0.0))));
}

bool isApart(PlaneAxis axis, vec2 corner)
{
    float place = dot(axis.direction, corner);
    return place < axis.lower || place > axis.upper || (place == axis.lower && axis.lowerIsOpen) ||
           (place == axis.upper && axis.upperIsOpen);
}

bool planeIsApart(vec3 normal, float offset, vec3 corner)
{
    float place = dot(normal, corner);
    vec3 upward = max(normal, 0.0);
    vec3 downward = min(normal, 0.0);
    float lower = offset - (upward.x + upward.y + upward.z);
    float upper = offset - (downward.x + downward.y + downward.z);
    return place < lower || place > upper || (place == lower && any(greaterThan(normal, vec3(0.0)))) ||
           (place == upper && any(lessThan(normal, vec3(0.0))));
}

// Twice the vector area between the origin and the part of the segment pq that lies in the unit cell, faces included.
vec3 sweptInCell(vec3 p, vec3 q)
{
    vec3 along = q - p;
    bvec3 still = equal(along, vec3(0.0));
    vec3 outside = vec3(lessThan(p, vec3(0.0))) + vec3(greaterThan(p, vec3(1.0)));
    if (dot(vec3(still), outside) > 0.0) return vec3(0.0);

    const float FAR = 1e30;
    vec3 inverse = 1.0 / mix(along, vec3(1.0), still);
    vec3 lower = -p * inverse;
    vec3 upper = (1.0 - p) * inverse;
    vec3 begins = mix(min(lower, upper), vec3(-FAR), still);
    vec3 ends = mix(max(lower, upper), vec3(FAR), still);
    float begin = max(max(begins.x, begins.y), max(begins.z, 0.0));
    float end = min(min(ends.x, ends.y), min(ends.z, 1.0));
    return begin < end ? cross(p + begin * along, p + end * along) : vec3(0.0);
}

// The chord along which the plane of a face cuts a triangle, from where its outline leaves the inner side to where it
// comes back; nothing where the plane misses it. face is 0 for the lower face of an axis and 1 for the upper.
vec3 sweptOnFace(vec3 a, vec3 b, vec3 c, int axis, float face)
{
    vec3 corners[3] = vec3[](a, b, c);
    vec3 leave = vec3(0.0);
    vec3 enter = vec3(0.0);
    bool isCut = false;
    for (int corner = 0; corner < 3; ++corner)
    {
        vec3 from = corners[corner];
        vec3 to = corners[(corner + 1) % 3];
        float here = face == 0.0 ? from[axis] : 1.0 - from[axis];
        float there = face == 0.0 ? to[axis] : 1.0 - to[axis];
        if ((here >= 0.0) == (there >= 0.0)) continue;
        vec3 crossing = mix(from, to, here / (here - there));
        crossing[axis] = face;
        if (here >= 0.0) leave = crossing;
        else enter = crossing;
        isCut = true;
    }
    return isCut ? sweptInCell(leave, enter) : vec3(0.0);
}

// The area of the part of a triangle inside the unit cell, by Stokes' theorem: the outline of that part is made of
// pieces of the triangle's edges and of its chords with the planes of the cell's faces.
float areaInCell(vec3 a, vec3 b, vec3 c, vec3 lowest, vec3 highest)
{
    vec3 sum = sweptInCell(a, b) + sweptInCell(b, c) + sweptInCell(c, a);
    for (int axis = 0; axis < 3; ++axis)
    {
        if (lowest[axis] < 0.0) sum += sweptOnFace(a, b, c, axis, 0.0);
        if (highest[axis] > 1.0) sum += sweptOnFace(a, b, c, axis, 1.0);
    }
    return 0.5 * length(sum);
}

void main()
{
    vec3 lowest = min(position[0], min(position[1], position[2]));
    vec3 highest = max(position[0], max(position[1], position[2]));
    ivec3 first = ivec3(lowest);
    ivec3 last = ivec3(highest);
    int firstInSlab = max(first.z, slab.x);
    int lastInSlab = min(last.z, slab.y - 1);
    if (firstInSlab > lastInSlab) return;

    // Near the origin, so that no digits are lost.
    vec3 origin = vec3(first);
    vec3 a = position[0] - origin;
    vec3 b = position[1] - origin;
    vec3 c = position[2] - origin;
    lowest -= origin;
    highest -= origin;

    vec3 normal = cross(b - a, c - a);
    float offset = dot(normal, a);
    PlaneAxis axes[9];
    for (int axis = 0; axis < 3; ++axis)
    {
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        vec2 a2 = vec2(a[u], a[v]);
        vec2 b2 = vec2(b[u], b[v]);
        vec2 c2 = vec2(c[u], c[v]);
        axes[3 * axis] = planeAxis(b2 - a2, a2, b2, c2);
        axes[3 * axis + 1] = planeAxis(c2 - b2, a2, b2, c2);
        axes[3 * axis + 2] = planeAxis(a2 - c2, a2, b2, c2);
    }

    ivec3 cell;
    for (cell.z = firstInSlab; cell.z <= lastInSlab; ++cell.z)
        for (cell.y = first.y; cell.y <= last.y; ++cell.y)
            for (cell.x = first.x; cell.x <= last.x; ++cell.x)
            {
                vec3 corner = vec3(cell - first);
                bool apart = planeIsApart(normal, offset, corner);
                for (int axis = 0; axis < 3; ++axis)
                {
                    vec2 corner2 = vec2(corner[(axis + 1) % 3], corner[(axis + 2) % 3]);
                    for (int edge = 0; edge < 3; ++edge) apart = apart || isApart(axes[3 * axis + edge], corner2);
                }
                if (apart) continue;
                weight = areaInCell(a - corner, b - corner, c - corner, lowest - corner, highest - corner) + LEAST_WEIGHT;
                sourceTriangle = triangle[0];
                packedCell = uvec2(cell.x | cell.y << 16, cell.z);
                gl_Position = positionOfTexel(texelOfCell(cell), voxelImageSize);
                EmitVertex();
                EndPrimitive();
            }
}
