// Models drawn partly built: finds the cells in place around each brick that is in place (class BrickNeighbors).

layout(location = 0) in uvec3 vertexBrick; // see BrickPoint

#include "polygonization/partial_bricks.glsl"

uniform usamplerBuffer cellRanks; // see createRankBlocks
uniform ivec3 gridSize;

flat out uvec3 neighbors; // captured by transform feedback

bool isCovered(ivec3 cell)
{
    if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, gridSize))) return false;
    ivec3 block = cell >> 3;
    ivec3 numBlocks = (gridSize + 7) >> 3;
    uint first = texelFetch(cellRanks, block.x + numBlocks.x * (block.y + numBlocks.y * block.z)).x;
    if (first == 0u) return false;
    ivec3 place = cell & 7;
    return texelFetch(cellRanks, int(first) + (place.x | place.y << 3 | place.z << 6)).x < uint(numPlaced);
}

#include "store/neighbor_bits.glsl"

void main()
{
    uint open = placedBrick(vertexBrick).y >> 16 & 63u;
    ivec3 cell = ivec3(vertexBrick.x & 0xffffu, vertexBrick.x >> 16, vertexBrick.y & 0xffffu);
    neighbors = open != 0u ? neighborBits(cell, open) : uvec3(0u);
}
