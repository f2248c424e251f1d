// Voxelization by points: every point has the same say in the colour of its cell. Blending adds them up; extraction
// divides by the sum of weights in alpha.

#include "passes/occupancy_marking.glsl"

flat in vec3 color;
flat in ivec3 cell;

void main()
{
    markCovered(cell);
    gl_FragColor = vec4(color, 1.0);
}
