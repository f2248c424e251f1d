// Polygonization, vertex shader: passes on one vertex for each brick.

layout(location = 0) in uvec3 vertexBrick; // see BrickPoint

flat out uvec3 brick;
#if defined(GRID_OCCLUSION)
flat out int vertexNumber;
#endif
#if defined(PARTIAL)
#include "polygonization/partial_bricks.glsl"

flat out uint vertexNovelty; // see noveltyHere
#endif

void main()
{
    brick = vertexBrick;
#if defined(GRID_OCCLUSION)
    vertexNumber = gl_VertexID;
#endif
#if defined(PARTIAL)
    brick = placedBrick(vertexBrick);
    vertexNovelty = noveltyHere();
#endif
}
