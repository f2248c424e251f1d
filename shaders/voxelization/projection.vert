// Voxelization by points, projected (the paper, section III-B, Algorithm 3): an orthographic picture of the vertices, of
// which the depth test keeps those nearest to it.

layout(location = 0) in vec3 vertexPosition;
layout(location = 2) in vec2 vertexCoordinate;
layout(location = 3) in uvec2 vertexColorAndLevel;

uniform mat4 projection; // from positions to the picture

flat out vec3 color;
flat out int cellNumber;

#include "passes/addressing.glsl"
#include "passes/surface_color.glsl"

void main()
{
    vec4 colorAndLevel = unpackColorAndLevel(vertexColorAndLevel);
    color = surfaceColor(colorAndLevel.rgb, vertexCoordinate, colorAndLevel.a);
    ivec3 cell = cellOfPosition(vertexPosition);
    cellNumber = cell.x + gridSize.x * (cell.y + gridSize.y * cell.z);
    gl_Position = projection * vec4(vertexPosition, 1.0);
    gl_Position.z = 0.5 + 0.5 * gl_Position.z; // not clipped with either depth range of glClipControl
    if (!isInGrid(cell)) gl_Position = NOWHERE;
}
