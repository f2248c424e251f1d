// The second component of the resolved depth: the node of a pixel, and its coverage.

struct PixelContents
{
    int number; // of the node, 0 to 255 (geometry_buffer.glsl)
    int count;  // of covered samples
};

float packContents(PixelContents contents)
{
    return float(contents.number | contents.count << 8);
}

PixelContents unpackContents(float value)
{
    int bits = int(value);
    return PixelContents(bits & 255, bits >> 8);
}
