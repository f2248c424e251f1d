// Voxelization by points, projected (the paper, Algorithm 4): a pixel tells one cell, by its number over how many there
// are, in alpha.

uniform float numberScale; // a power of two no smaller than the number of cells, so that dividing by it is exact

flat in vec3 color;
flat in int cellNumber;

void main()
{
    gl_FragColor = vec4(color, float(cellNumber) / numberScale);
}
