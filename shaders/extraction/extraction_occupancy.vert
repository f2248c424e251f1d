// Extraction, used if voxelization could not mark covered cells: a vertex for each word of the occupancy reads the
// texels of its cells in the voxel image.

uniform sampler2D voxelImage;

flat out uint word; // captured by transform feedback

#include "passes/occupancy.glsl"

void main()
{
    ivec3 corner = cornerOfWord(gl_VertexID);
    word = 0u;
    for (int bit = 0; bit < 32; ++bit)
    {
        ivec3 cell = corner + ivec3(bit & 3, bit >> 2 & 3, bit >> 4);
        if (any(greaterThanEqual(cell, ivec3(gridSize.xy, slab.y))) || cell.z < slab.x) continue;
        if (texelFetch(voxelImage, texelOfCell(cell), 0).a > 0.0) word |= bitOfCell(cell);
    }
}
