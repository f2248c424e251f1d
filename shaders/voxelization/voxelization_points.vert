// Voxelization by points, addressed (the paper's future work): each vertex is drawn on the texel of its cell.

layout(location = 0) in vec3 vertexPosition;
layout(location = 2) in vec2 vertexCoordinate;
layout(location = 3) in uvec2 vertexColorAndLevel;

flat out vec3 color;
flat out ivec3 cell;

#include "passes/addressing.glsl"
#include "passes/surface_color.glsl"

void main()
{
    vec4 colorAndLevel = unpackColorAndLevel(vertexColorAndLevel);
    color = surfaceColor(colorAndLevel.rgb, vertexCoordinate, colorAndLevel.a);
    cell = cellOfPosition(vertexPosition);
    bool inSlab = cell.z >= slab.x && cell.z < slab.y;
    gl_Position = inSlab && isInGrid(cell) ? positionOfTexel(texelOfCell(cell), voxelImageSize) : NOWHERE;
}
