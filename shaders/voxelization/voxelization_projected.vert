// Voxelization by points, projected, second half: each pixel of the orthographic picture, read by one vertex, is drawn
// on the texel of the cell whose number it contains.

uniform sampler2D picture; // alpha below 0: empty
uniform float numberScale;

flat out vec3 color;
flat out ivec3 cell;

#include "passes/addressing.glsl"

void main()
{
    ivec2 pictureSize = textureSize(picture, 0);
    vec4 pixel = texelFetch(picture, ivec2(gl_VertexID % pictureSize.x, gl_VertexID / pictureSize.x), 0);
    int number = int(pixel.a * numberScale); // exact, because the scale is a power of two
    int row = number / gridSize.x;
    cell = ivec3(number - row * gridSize.x, row % gridSize.y, row / gridSize.y);
    bool inSlab = pixel.a >= 0.0 && cell.z >= slab.x && cell.z < slab.y;
    color = pixel.rgb;
    gl_Position = inSlab ? positionOfTexel(texelOfCell(cell), voxelImageSize) : NOWHERE;
}
