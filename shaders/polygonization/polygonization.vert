// Polygonization, vertex shader: passes on one vertex for each brick.

layout(location = 0) in uvec3 vertexBrick; // see BrickPoint

flat out uvec3 brick;

void main()
{
    brick = vertexBrick;
}
