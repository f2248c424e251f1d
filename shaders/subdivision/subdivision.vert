// Subdivision, vertex shader: passes the vertices through.

layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in uint vertexTriangle;
layout(location = 2) in vec2 vertexCoordinate;
layout(location = 3) in uvec2 vertexColorAndLevel;

out Corner
{
    vec3 position;
    vec2 coordinate;
    vec4 colorAndLevel;
    flat uint triangle;
} corner;

#include "passes/vertex_packing.glsl"

void main()
{
    corner.position = vertexPosition;
    corner.coordinate = vertexCoordinate;
    corner.colorAndLevel = unpackColorAndLevel(vertexColorAndLevel);
    corner.triangle = vertexTriangle;
}
