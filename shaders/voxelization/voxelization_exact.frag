// Exact voxelization, the sums: every covering triangle contributes a colour, weighted by its area inside the cell.
// Blending sums up weighted colours, and weights in alpha; extraction divides.

#include "passes/occupancy_marking.glsl"

flat in float weight;
flat in uvec2 packedCell;

#include "passes/voxel_color.glsl"
#include "voxelization/color_in_cell.glsl"
#include "gl/fragment_outputs.glsl"

void main()
{
    ivec3 cell = ivec3(packedCell.x & 0xffffu, packedCell.x >> 16, packedCell.y);
    markCovered(cell);
    vec3 center = vec3(cell + firstCell) + 0.5;
    fragmentColor = weightedColor(filteredColor(pointInCell(center)), weight);
}
