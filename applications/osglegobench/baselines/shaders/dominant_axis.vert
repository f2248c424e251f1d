// Dominant axis, vertex shader: passes the vertices through.

layout(location = 0) in vec3 vertexPosition;
layout(location = 2) in vec2 vertexCoordinate;
layout(location = 3) in uvec2 vertexColorAndLevel;

out vec3 position;
out vec2 coordinate;
out vec4 colorAndLevel;

#include "passes/vertex_packing.glsl"

void main()
{
    position = vertexPosition;
    coordinate = vertexCoordinate;
    colorAndLevel = unpackColorAndLevel(vertexColorAndLevel);
}
