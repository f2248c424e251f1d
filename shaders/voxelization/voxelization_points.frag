// Voxelization by points: all points in a cell contribute equally to its colour. Blending sums up the colours;
// extraction divides by the sum of weights in alpha.

#include "passes/occupancy_marking.glsl"

flat in vec3 color;
flat in ivec3 cell;

void main()
{
    markCovered(cell);
    gl_FragColor = vec4(color, 1.0);
}
