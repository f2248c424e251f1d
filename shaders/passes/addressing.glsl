// The texels of the cells of a slab (whole layers of the grid) in the voxel image: one texel per cell, row by row.

uniform ivec3 gridSize;       // cells along x, y and z
uniform ivec2 slab;           // the first layer (z) in the image, and the one after the last
uniform ivec2 voxelImageSize; // texels; the width is a power of two
uniform int voxelImageShift;  // the binary logarithm of the width

uniform ivec3 firstCell;      // the cell of positions that is cell (0, 0, 0) of the grid; see GridTriangles

// The cell that contains a position, which is not negative.
ivec3 cellOfPosition(vec3 position)
{
    return ivec3(position) - firstCell;
}

bool isInGrid(ivec3 cell)
{
    return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, gridSize));
}

ivec2 texelOfCell(ivec3 cell)
{
    int number = cell.x + gridSize.x * (cell.y + gridSize.y * (cell.z - slab.x));
    return ivec2(number & (voxelImageSize.x - 1), number >> voxelImageShift);
}

// The clip coordinates of the centre of a texel.
vec4 positionOfTexel(ivec2 texel, ivec2 imageSize)
{
    return vec4((vec2(texel) + 0.5) / vec2(imageSize) * 2.0 - 1.0, 0.0, 1.0);
}

// Clip coordinates that produce no fragment.
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
