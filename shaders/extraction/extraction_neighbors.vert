// Extraction, the neighbours: finds the covered cells around each brick. Class BrickNeighbors states the order of their bits.

layout(location = 0) in uvec3 brick; // see extraction.geom

uniform usamplerBuffer occupancy;

flat out uvec3 neighbors; // captured by transform feedback

#include "passes/occupancy.glsl"

bool isCovered(ivec3 cell)
{
    bool isInside = all(greaterThanEqual(cell, ivec3(0, 0, slab.x))) && all(lessThan(cell, ivec3(gridSize.xy, slab.y)));
    return isInside && (texelFetch(occupancy, wordOfCell(cell)).r & bitOfCell(cell)) != 0u;
}

#include "store/neighbor_bits.glsl"

void main()
{
    neighbors = neighborBits(ivec3(brick.x & 0xffffu, brick.x >> 16, brick.y & 0xffffu), brick.y >> 16 & 63u);
}
