// Subdivision, vertex shader: passes the vertices through.

layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in uint vertexTriangle;
#ifdef HAS_COLORS
layout(location = 2) in vec2 vertexCoordinate;
layout(location = 3) in uvec2 vertexColorAndLevel;
#endif

out Corner
{
    vec3 position;
    flat uint triangle;
#ifdef HAS_COLORS
    vec2 coordinate;
    vec4 colorAndLevel;
#endif
} corner;

#include "passes/vertex_packing.glsl"

void main()
{
    corner.position = vertexPosition;
    corner.triangle = vertexTriangle;
#ifdef HAS_COLORS
    corner.coordinate = vertexCoordinate;
    corner.colorAndLevel = unpackColorAndLevel(vertexColorAndLevel);
#endif
}
