// The covered cells around a brick, in the order of class BrickNeighbors. The shader that includes this defines
// `bool isCovered(ivec3 cell)`, for cells inside and outside the grid.

uvec3 bits = uvec3(0u);
int next = 0; // bit

void add(ivec3 cell)
{
    if (isCovered(cell)) bits[next >> 5] |= 1u << (next & 31);
    ++next;
}

void addEdges(ivec3 cell)
{
    for (int axis = 0; axis < 3; ++axis)
        for (int edge = 0; edge < 4; ++edge)
        {
            ivec3 neighbor = cell;
            neighbor[(axis + 1) % 3] += 2 * (edge & 1) - 1;
            neighbor[(axis + 2) % 3] += (edge & 2) - 1;
            add(neighbor);
        }
}

void addLayer(ivec3 cell, int axis, int distance)
{
    for (int v = -1; v <= 1; ++v)
        for (int u = -1; u <= 1; ++u)
        {
            ivec3 neighbor = cell;
            neighbor[axis] += distance;
            neighbor[(axis + 1) % 3] += u;
            neighbor[(axis + 2) % 3] += v;
            add(neighbor);
        }
}

uvec3 neighborBits(ivec3 cell, uint open)
{
    addEdges(cell);
    for (int corner = 0; corner < 8; ++corner)
        add(cell + 2 * ivec3(corner & 1, corner >> 1 & 1, corner >> 2) - 1);
    int numLayers = bitCount(open) < 5 ? 2 : 1;
    for (int side = 0; side < 6; ++side)
        for (int layer = 0; layer < numLayers && (open >> side & 1u) != 0u; ++layer)
            addLayer(cell, side >> 1, (side & 1) != 0 ? 2 + layer : -2 - layer);
    return bits;
}
