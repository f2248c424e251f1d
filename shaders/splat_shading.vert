// Shading of splats: the part of the picture that bricks lie in.

uniform vec4 area; // from -1 to 1: left, lower, right, upper

void main()
{
    vec2 place = vec2((gl_VertexID & 1) == 0 ? area.x : area.z, gl_VertexID < 2 ? area.y : area.w);
    gl_Position = vec4(place, 0.0, 1.0);
}
