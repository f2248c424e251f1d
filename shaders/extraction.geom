// Extraction: the voxel image becomes one point for each covered cell that has an empty neighbour.

layout(points) in;
layout(points, max_vertices = RUN_LENGTH) out;

flat in int run[];

uniform sampler2D voxelImage; // weighted colours, and the sum of weights in alpha: above 0 where a cell is covered
uniform int firstLayer;       // the layer (z) to begin with; the image holds those beside as well

// Captured by transform feedback: x | y << 16, z | open sides << 16, colour.
flat out uvec3 brick;

#include "addressing.glsl"

vec4 voxelAt(ivec3 cell)
{
    if (any(lessThan(cell, ivec3(0))) || any(greaterThanEqual(cell, gridSize))) return vec4(0.0);
    return texelFetch(voxelImage, texelOfCell(cell), 0);
}

uint openBit(ivec3 cell, uint bit)
{
    return voxelAt(cell).a > 0.0 ? 0u : bit;
}

void main()
{
    int runs = (gridSize.x + RUN_LENGTH - 1) / RUN_LENGTH;
    int row = run[0] / runs;
    ivec3 cell = ivec3((run[0] - row * runs) * RUN_LENGTH, row % gridSize.y, row / gridSize.y + firstLayer);
    int end = min(cell.x + RUN_LENGTH, gridSize.x);
    for (; cell.x < end; ++cell.x)
    {
        vec4 voxel = voxelAt(cell);
        if (voxel.a <= 0.0) continue;
        uint open = openBit(cell - ivec3(1, 0, 0), 1u) | openBit(cell + ivec3(1, 0, 0), 2u) |
                    openBit(cell - ivec3(0, 1, 0), 4u) | openBit(cell + ivec3(0, 1, 0), 8u) |
                    openBit(cell - ivec3(0, 0, 1), 16u) | openBit(cell + ivec3(0, 0, 1), 32u);
        if (open == 0u) continue;
        brick = uvec3(cell.x | cell.y << 16, uint(cell.z) | open << 16, packUnorm4x8(vec4(voxel.rgb / voxel.a, 1.0)));
        EmitVertex();
        EndPrimitive();
    }
}
