// Slice maps: the grid seen along z, one pixel per column of cells. Depth is in cells, divided by a power of two.

layout(location = 0) in vec3 vertexPosition;

uniform vec2 pictureSize; // cells
uniform float depthRange; // cells from depth 0 to depth 1

void main()
{
    gl_Position = vec4(2.0 * vertexPosition.xy / pictureSize - 1.0, 2.0 * vertexPosition.z / depthRange - 1.0, 1.0);
}
