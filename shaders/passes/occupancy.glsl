// The covered cells of a slab, one bit per cell: a word holds 4 x 4 x 2 cells, and the 16 words of a block of 8 x 8 x 8
// cells are consecutive.

#include "passes/addressing.glsl"

int countBlocks(int cells)
{
    return (cells + 7) >> 3;
}

int wordOfCell(ivec3 cell)
{
    ivec3 block = ivec3(cell.xy, cell.z - (slab.x & ~7)) >> 3;
    int number = block.x + countBlocks(gridSize.x) * (block.y + countBlocks(gridSize.y) * block.z);
    return number << 4 | (cell.z & 6) << 1 | (cell.y & 4) >> 1 | (cell.x & 4) >> 2;
}

uint bitOfCell(ivec3 cell)
{
    return 1u << ((cell.z & 1) << 4 | (cell.y & 3) << 2 | (cell.x & 3));
}

// The cell with the lowest coordinates in a word.
ivec3 cornerOfWord(int word)
{
    int row = (word >> 4) / countBlocks(gridSize.x);
    int layer = row / countBlocks(gridSize.y);
    ivec3 block = ivec3((word >> 4) - row * countBlocks(gridSize.x), row - layer * countBlocks(gridSize.y), layer);
    return (block << 3) + ivec3((word & 1) << 2, (word & 2) << 1, (word & 12) >> 1) + ivec3(0, 0, slab.x & ~7);
}
