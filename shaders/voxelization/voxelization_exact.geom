// Exact voxelization: a fine triangle emits a point for each cell that it overlaps.
//
// The test is Akenine-Moller's (Fast 3D Triangle-Box Overlap Testing, 2001) with half-open cells: the lower faces of a
// cell belong to it, its upper faces do not. TriangleOverlap is the counterpart on the CPU, in double precision.

layout(triangles) in;
// The largest number of cells that a triangle within the edge limit meets.
layout(points, max_vertices = MAXIMUM_CELLS) out;

in vec3 position[];
flat in uint triangle[];

flat out float weight;        // the fine triangle's area inside the cell
flat out uint sourceTriangle; // the triangle that it was cut from
flat out uvec2 packedCell;    // x | y << 16, z; computing the cell from the texel would take divisions

#include "osgLego/data/PassConstants.h"
#include "passes/addressing.glsl"
#include "voxelization/area_in_cell.glsl"

// A separating axis in a coordinate plane: it separates a cell from the triangle if the projection of the cell's corner
// on the axis is outside the bounds, or equal to an open bound. The last members are 1 or 0: drivers that translate GLSL to
// SPIR-V, such as Mesa's zink, make invalid types of booleans in structures.
struct PlaneAxis
{
    vec2 direction;
    float lower;
    float upper;
    int lowerIsOpen;
    int upperIsOpen;
};

PlaneAxis planeAxis(vec2 edge, vec2 a, vec2 b, vec2 c)
{
    vec2 direction = vec2(-edge.y, edge.x);
    vec3 places = vec3(dot(direction, a), dot(direction, b), dot(direction, c));
    vec2 upward = max(direction, 0.0);
    vec2 downward = min(direction, 0.0);
    return PlaneAxis(direction, min(places.x, min(places.y, places.z)) - (upward.x + upward.y),
                     max(places.x, max(places.y, places.z)) - (downward.x + downward.y),
                     int(any(greaterThan(direction, vec2(0.0)))), int(any(lessThan(direction, vec2(0.0)))));
}

bool isApart(PlaneAxis axis, vec2 corner)
{
    float place = dot(axis.direction, corner);
    return place < axis.lower || place > axis.upper || (place == axis.lower && axis.lowerIsOpen != 0) ||
           (place == axis.upper && axis.upperIsOpen != 0);
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

// The axis along which a vector is longest.
int longestAxis(vec3 vector)
{
    vec3 size = abs(vector);
    if (size.z >= max(size.x, size.y)) return 2;
    return size.x >= size.y ? 0 : 1;
}

// The components in cyclic order, ending with that of the axis `last`.
vec3 reordered(vec3 vector, int last)
{
    return last == 2 ? vector : last == 0 ? vector.yzx : vector.zxy;
}

void main()
{
    vec3 lowest = min(position[0], min(position[1], position[2]));
    vec3 highest = max(position[0], max(position[1], position[2]));
    ivec3 first = ivec3(lowest);
    ivec3 firstInSlab = max(first, firstCell + ivec3(0, 0, slab.x));
    ivec3 lastInSlab = min(ivec3(highest), firstCell + ivec3(gridSize.xy, slab.y) - 1);
    if (any(greaterThan(firstInSlab, lastInSlab))) return;

    // Moved near the origin, to avoid cancellation.
    vec3 origin = vec3(first);
    vec3 a = position[0] - origin;
    vec3 b = position[1] - origin;
    vec3 c = position[2] - origin;
    lowest -= origin;
    highest -= origin;

    vec3 normal = cross(b - a, c - a);
    float offset = dot(normal, a);
    float area = 0.5 * length(normal);
    int projection = longestAxis(normal);
    // 0 for a triangle without area.
    float perProjected = area > 0.0 ? 2.0 * area / abs(normal[projection]) : 0.0;
    vec3 projected[3] = vec3[](reordered(a, projection), reordered(b, projection), reordered(c, projection));
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
    for (cell.z = firstInSlab.z; cell.z <= lastInSlab.z; ++cell.z)
        for (cell.y = firstInSlab.y; cell.y <= lastInSlab.y; ++cell.y)
            for (cell.x = firstInSlab.x; cell.x <= lastInSlab.x; ++cell.x)
            {
                vec3 corner = vec3(cell - first);
                bool apart = planeIsApart(normal, offset, corner);
                for (int axis = 0; axis < 3; ++axis)
                {
                    vec2 corner2 = vec2(corner[(axis + 1) % 3], corner[(axis + 2) % 3]);
                    for (int edge = 0; edge < 3; ++edge) apart = apart || isApart(axes[3 * axis + edge], corner2);
                }
                if (apart) continue;
                bool isInside = all(greaterThanEqual(lowest, corner)) && all(lessThanEqual(highest, corner + 1.0));
                vec3 shift = reordered(corner, projection);
                weight = LEAST_WEIGHT + (isInside ? area
                                                  : areaInCell(projected[0] - shift, projected[1] - shift,
                                                               projected[2] - shift, perProjected));
                sourceTriangle = triangle[0];
                ivec3 cellInGrid = cell - firstCell;
                packedCell = uvec2(cellInGrid.x | cellInGrid.y << 16, cellInGrid.z);
                gl_Position = positionOfTexel(texelOfCell(cellInGrid), voxelImageSize);
                EmitVertex();
                EndPrimitive();
            }
}
