// The second component of the resolved depth: the node of a pixel, and its coverage.

struct PixelContents
{
    int number;   // of the node, 0 to 255 (geometry_buffer.glsl)
    int covered;  // samples that show the pixel's surface
    int other;    // samples that show the surface of a neighbouring pixel, before or behind a silhouette
    int neighbor; // index of that pixel in NEIGHBORS
};

const ivec2 NEIGHBORS[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));

float packContents(PixelContents contents)
{
    return float(contents.number | contents.covered << 8 | contents.other << 14 | contents.neighbor << 20);
}

PixelContents unpackContents(float value)
{
    int bits = int(value);
    return PixelContents(bits & 255, bits >> 8 & 63, bits >> 14 & 63, bits >> 20);
}
