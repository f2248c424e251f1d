// Dominant axis: creates a point for every listed cell with an empty neighbour, or for all listed cells.

layout(local_size_x = 256) in;

layout(binding = 0, r32ui) readonly uniform uimage3D volume;
layout(std430, binding = 0) buffer Counters { uint numCells; uint numPoints; };
layout(std430, binding = 1) readonly buffer Cells { uint cells[]; };
layout(std430, binding = 2) writeonly buffer Points { uint points[]; }; // x | y << 16, z | open sides << 16, colour

uniform ivec3 gridSize;
uniform int takesHidden;

uint openBit(ivec3 cell, uint bit)
{
    bool isInside = all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, gridSize));
    return isInside && imageLoad(volume, cell).r != 0u ? 0u : bit;
}

void main()
{
    if (gl_GlobalInvocationID.x >= numCells) return;
    uint number = cells[gl_GlobalInvocationID.x];
    uvec3 size = uvec3(gridSize);
    ivec3 cell = ivec3(number % size.x, number / size.x % size.y, number / size.x / size.y);
    uint open = openBit(cell - ivec3(1, 0, 0), 1u) | openBit(cell + ivec3(1, 0, 0), 2u) |
                openBit(cell - ivec3(0, 1, 0), 4u) | openBit(cell + ivec3(0, 1, 0), 8u) |
                openBit(cell - ivec3(0, 0, 1), 16u) | openBit(cell + ivec3(0, 0, 1), 32u);
    if (open == 0u && takesHidden == 0) return;
    uint point = 3u * atomicAdd(numPoints, 1u);
    points[point] = uint(cell.x | cell.y << 16);
    points[point + 1u] = uint(cell.z) | open << 16;
    points[point + 2u] = imageLoad(volume, cell).r | 0xff000000u;
}
