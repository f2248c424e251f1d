// Slice maps: outputs the bit of the fragment's cell, with 128 bits of the column per target. GL's logic operation
// combines it with the stored bits by OR.

layout(location = 0) out uvec4 slices[NUM_TARGETS];

uniform float depthRange; // cells from depth 0 to depth 1
uniform int firstLayer;   // the first layer in the first target

void main()
{
    int layer = int(gl_FragCoord.z * depthRange) - firstLayer;
    for (int target = 0; target < NUM_TARGETS; ++target)
    {
        ivec4 bit = layer - 128 * target - ivec4(0, 32, 64, 96);
        bvec4 isHere = equal(bit & ~31, ivec4(0));
        slices[target] = uvec4(isHere) << uvec4(bit & 31);
    }
}
