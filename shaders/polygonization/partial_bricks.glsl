// Models drawn partly built (#define PARTIAL): decides which cells are in place, and which of their sides are open.

// See CellRanks.
layout(location = 1) in uint rank;
layout(location = 2) in uvec3 lowerRanks;
layout(location = 3) in uvec3 upperRanks;

uniform int numPlaced; // parts in place
uniform int numOld;    // parts in place that are not highlighted

// The point of a cell with the sides that are open now: none unless the cell is in place.
uvec3 placedBrick(uvec3 brick)
{
    uvec3 isLowerOpen = uvec3(greaterThanEqual(lowerRanks, uvec3(numPlaced)));
    uvec3 isUpperOpen = uvec3(greaterThanEqual(upperRanks, uvec3(numPlaced)));
    uvec3 open = (isLowerOpen | isUpperOpen << 1) << uvec3(16u, 18u, 20u);
    uint sides = rank < uint(numPlaced) ? open.x | open.y | open.z : 0u;
    return uvec3(brick.x, (brick.y & ~(63u << 16)) | sides, brick.z);
}

// 1 for a cell of a highlighted part, otherwise 0.
uint noveltyHere()
{
    return rank >= uint(numOld) ? 1u : 0u;
}
