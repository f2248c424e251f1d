// Voxelization by points: the last point in a cell determines its colour.

#include "passes/occupancy_marking.glsl"
#include "gl/fragment_outputs.glsl"

flat in vec3 color;
flat in ivec3 cell;

void main()
{
    markCovered(cell);
    fragmentColor = vec4(color, 1.0);
}
