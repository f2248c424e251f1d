// Polygonization into a depth buffer without colours.

#include "gl/fragment_outputs.glsl"

void main()
{
    fragmentColor = vec4(1.0); // opaque, for an alpha test
}
