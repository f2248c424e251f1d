// A picture of the grid along one of its axes, one pixel per column of cells. Depth is in cells, divided by a power
// of two.

layout(location = 0) in vec3 vertexPosition;
layout(location = 2) in vec2 vertexCoordinate;
layout(location = 3) in uvec2 vertexColorAndLevel;

uniform int axis;          // the view axis
uniform vec2 pictureSize;  // cells
uniform float depthRange;  // cells from depth 0 to depth 1

noperspective out vec2 coordinate;
noperspective out vec3 color;
flat out float level;

#include "passes/vertex_packing.glsl"

// Peeling compares depths from pass to pass.
invariant gl_Position;

void main()
{
    vec4 colorAndLevel = unpackColorAndLevel(vertexColorAndLevel);
    color = colorAndLevel.rgb;
    level = colorAndLevel.a;
    coordinate = vertexCoordinate;
    vec2 place = vec2(vertexPosition[(axis + 1) % 3], vertexPosition[(axis + 2) % 3]);
    gl_Position = vec4(2.0 * place / pictureSize - 1.0, 2.0 * vertexPosition[axis] / depthRange - 1.0, 1.0);
}
