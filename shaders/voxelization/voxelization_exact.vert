// Exact voxelization, vertex shader: passes the vertices through.

layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in uint vertexTriangle;

out vec3 position;
flat out uint triangle;

void main()
{
    position = vertexPosition;
    triangle = vertexTriangle;
}
