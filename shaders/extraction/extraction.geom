// Extraction: emits a point for each covered cell of a word that has an empty neighbour.

layout(points) in;
layout(points, max_vertices = 32) out;

flat in int word[];

uniform sampler2D voxelImage; // passes/voxel_color.glsl
uniform usamplerBuffer occupancy;
uniform ivec2 layers; // (z) the first to extract, and the one after the last; the image also has their neighbours

// Captured by transform feedback: x | y << 16, z | open sides << 16, colour (see BrickPoint; its alpha is NO_PART).
flat out uvec3 brick;

#include "passes/occupancy.glsl"
#include "passes/voxel_color.glsl"
#ifdef PALETTE
#include "extraction/palette_color.glsl"
#endif

uint wordAt(ivec3 cell)
{
    bool isInside = all(greaterThanEqual(cell, ivec3(0, 0, slab.x))) &&
                    all(lessThan(cell, ivec3(gridSize.xy, slab.y)));
    return isInside ? texelFetch(occupancy, wordOfCell(cell)).r : 0u;
}

// A mask of the cells of a word in the layers to extract.
uint wantedCells(int z)
{
    uint lower = z >= layers.x && z < layers.y ? 0x0000ffffu : 0u;
    uint upper = z + 1 >= layers.x && z + 1 < layers.y ? 0xffff0000u : 0u;
    return lower | upper;
}

uint packedColor(ivec3 cell, vec4 voxel)
{
#ifdef PALETTE
    uvec3 color = uvec3(paletteColor(ivec3(255.0 * colorOfVoxel(voxel) + 0.5), cell));
    return color.r | color.g << 8 | color.b << 16 | 0xff000000u;
#else
    return packUnorm4x8(vec4(colorOfVoxel(voxel), 1.0));
#endif
}

void main()
{
    // Masks of the cells on each side of their word.
    const uint LEFT = 0x11111111u;
    const uint RIGHT = 0x88888888u;
    const uint FRONT = 0x000f000fu;
    const uint BACK = 0xf000f000u;

    ivec3 corner = cornerOfWord(word[0]);
    uint covered = texelFetch(occupancy, word[0]).r;
    // Masks of the cells that have a covered neighbour on each side, in the same word or in the next.
    uint left = (covered << 1 & ~LEFT) | (wordAt(corner - ivec3(1, 0, 0)) >> 3 & LEFT);
    uint right = (covered >> 1 & ~RIGHT) | (wordAt(corner + ivec3(4, 0, 0)) << 3 & RIGHT);
    uint front = (covered << 4 & ~FRONT) | (wordAt(corner - ivec3(0, 1, 0)) >> 12 & FRONT);
    uint back = (covered >> 4 & ~BACK) | (wordAt(corner + ivec3(0, 4, 0)) << 12 & BACK);
    uint below = covered << 16 | wordAt(corner - ivec3(0, 0, 1)) >> 16;
    uint above = covered >> 16 | wordAt(corner + ivec3(0, 0, 2)) << 16;

    uint visible = covered & ~(left & right & front & back & below & above) & wantedCells(corner.z);
    while (visible != 0u)
    {
        int bit = findLSB(visible);
        visible &= visible - 1u;
        ivec3 cell = corner + ivec3(bit & 3, bit >> 2 & 3, bit >> 4);
        uint closed = (left >> bit & 1u) | (right >> bit & 1u) << 1 | (front >> bit & 1u) << 2 |
                      (back >> bit & 1u) << 3 | (below >> bit & 1u) << 4 | (above >> bit & 1u) << 5;
        vec4 voxel = texelFetch(voxelImage, texelOfCell(cell), 0);
        brick = uvec3(cell.x | cell.y << 16, uint(cell.z) | (closed ^ 63u) << 16, packedColor(cell, voxel));
        EmitVertex();
        EndPrimitive();
    }
}
