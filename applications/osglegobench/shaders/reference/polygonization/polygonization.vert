// Polygonization, vertex shader: passes on one vertex for each brick.

layout(location = 0) in uvec3 vertexBrick; // x | y << 16, z | open sides << 16, colour

flat out uvec3 brick;

void main()
{
    brick = vertexBrick;
}
