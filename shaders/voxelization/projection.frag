// Voxelization by points, projected (the paper, Algorithm 4): the alpha of a pixel is the number of its cell, divided
// by numberScale.

#include "gl/fragment_outputs.glsl"

uniform float numberScale; // a power of two no smaller than the number of cells, so that dividing by it is exact

flat in vec3 color;
flat in int cellNumber;

void main()
{
    fragmentColor = vec4(color, float(cellNumber) / numberScale);
}
