// Voxelization by points: every point has the same say in the colour of its cell. Blending adds them up; extraction
// divides by the sum of weights in alpha.

flat in vec3 color;

void main()
{
    gl_FragColor = vec4(color, 1.0);
}
