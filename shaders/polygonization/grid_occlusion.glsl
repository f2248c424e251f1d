// Near occlusion of bricks by the cells around them (see createOcclusionTable and BrickNeighbors): exact but for the cells that are
// left out, without noise, and independent of the view.

uniform usamplerBuffer neighbors; // three texels for each brick
#if defined(SPLATS)
#define numNeighbors sceneSplats.z
#else
uniform int numNeighbors; // of bricks; others count as alone
#endif
uniform sampler2D occlusionTable; // in quarters: faces on top and below, those at the sides; likewise, differences

const vec2 TABLE_SIZE = vec2(512.0, 1024.0); // texels, see createOcclusionTable; asking the sampler takes longer
const float QUARTER = 256.0;                 // lines
const float PATTERN_SIDE = 8.0;              // texels of a pattern
const uint PATTERNS_ACROSS = 64u;
// The values of an open quadrant: visibility, and the bent vector along the face and along its normal.
const vec4 OPEN_QUADRANT = vec4(0.25, 0.106103295, 0.106103295, 0.166666667);

// Cells in front of a face are bits, (u + 1) + 3 * (v + 1) + 9 * layer, where u and v are -1 to 1 along the axes of the face.
const uint LAYERS = 0x40201u; // a bit of each of three layers
const uint MIDDLE = 4u;       // the bit in the middle of a layer; right in front of the face, the cell is empty
const uint QUADRANT = 0x1bu;  // the cells of the lower quadrant in a layer
const uint ALL_QUADRANTS = QUADRANT * LAYERS;

// The bits of all layers with both axes exchanged.
uint exchangeAxes(uint cells)
{
    const uint DIAGONAL = 0x111u * LAYERS;
    const uint BESIDE = 0x22u * LAYERS;
    const uint CORNER = 4u * LAYERS;
    return (cells & DIAGONAL) | (cells & BESIDE) << 2 | (cells >> 2 & BESIDE) | (cells & CORNER) << 4 | (cells >> 4 & CORNER);
}

// The cells in front of a face. `words` is a BrickNeighbors; the axes of the face are the two that follow `axis`.
uint cellsInFront(uvec3 words, uint open, int axis, int upper)
{
    ivec2 axes = axesOf(axis, true);
    uint besideFirst = words.x >> (4 * axes.y + upper);
    uint besideSecond = words.x >> (4 * axes.x + 2 * upper);
    uint corners = words.x >> (12 + (upper << axis));
    ivec2 steps = ivec2(1) << axes;
    uint cells = (besideFirst & 5u) << 3 | (besideSecond & 1u) << 1 | (besideSecond & 2u) << 6 | (corners & 1u) |
                 (corners >> steps.x & 1u) << 2 | (corners >> steps.y & 1u) << 6 | (corners >> (steps.x + steps.y) & 1u) << 8;
    // The other layers.
    int numBefore = bitCount(open & ((1u << (2 * axis + upper)) - 1u));
    bool hasThird = bitCount(open) < 5;
    int place = 20 + numBefore * (hasThird ? 18 : 9);
    int shift = place & 31;
    uvec2 pair = place < 32 ? words.xy : place < 64 ? words.yz : words.zz;
    uint far = pair.x >> shift | (shift == 0 ? 0u : pair.y << (32 - shift));
    return cells | (far & (hasThird ? 0x3ffffu : 0x1ffu)) << 9;
}

// The cells on the level of a brick, whose face is perpendicular to an axis: those beside it, and the brick.
uint cellsBeside(uint word, uint open, int axis)
{
    ivec2 axes = axesOf(axis, true);
    uvec2 beside = ~uvec2(open) >> (2 * axes);
    uint corners = word >> (4 * axis);
    return 1u << MIDDLE | (beside.x & 1u) << 3 | (beside.x & 2u) << 4 | (beside.y & 1u) << 1 | (beside.y & 2u) << 6 |
           (corners & 1u) | (corners & 2u) << 1 | (corners & 4u) << 4 | (corners & 8u) << 5;
}

// The pattern of the cells of a quadrant. `sides` are 1 for the upper ends of the axes along the face.
uint patternOf(uint cells, ivec2 sides)
{
    const uint LOWER_FIRST = 9u * LAYERS;
    const uint LOWER_SECOND = 3u * LAYERS;
    uint bits = cells >> (sides.x + 3 * sides.y) & ALL_QUADRANTS;
    if (sides.x == 0) bits = (bits & LOWER_FIRST) << 1 | (bits >> 1 & LOWER_FIRST);
    if (sides.y == 0) bits = (bits & LOWER_SECOND) << 3 | (bits >> 3 & LOWER_SECOND);
    bits = (bits & LOWER_SECOND) | (bits >> 1 & 12u * LAYERS);
    return (bits >> 1 & 7u) | (bits >> 6 & 0x78u) | (bits >> 11 & 0x780u);
}

// An entry of the table. `position` is 0 to 1, `firstLine` that of a quarter.
vec4 entryOf(uint pattern, vec2 position, float firstLine)
{
    vec2 block = vec2(pattern & PATTERNS_ACROSS - 1u, pattern / PATTERNS_ACROSS);
    vec2 texel = block * PATTERN_SIDE + 0.5 + clamp(position, 0.0, 1.0) * (PATTERN_SIDE - 1.0) + vec2(0.0, firstLine);
    return textureLod(occlusionTable, texel / TABLE_SIZE, 0.0);
}

// The light that four quadrants receive: those at the lower ends of both axes of a face, at the upper end of the first, of the
// second, of both.
struct Quadrants
{
    vec4 sum;         // visibility and bent vector, along both axes and the outward normal
    vec4 visibility;  // of each quadrant, as a fraction of that without cells
    float difference; // from the visibility that is interpolated between faces
    vec2 shift;       // from the place to the one for which it is interpolated, in cells
};

// The light of all quadrants, with weights. `place` is the position along the axes, 0 to 1; for a side of the brick, the first
// axis is horizontal.
Quadrants findQuadrants(uint cells, vec2 place, vec4 weights, bool isLevel)
{
    float firstLine = isLevel ? 0.0 : QUARTER;
    ivec2 nearest = ivec2(greaterThanEqual(place, vec2(0.5)));
    float difference = entryOf(patternOf(cells, nearest), abs(2.0 * place - 1.0), firstLine + 2.0 * QUARTER).x;
    // There is nothing to interpolate with in a covered cell beside the face.
    vec2 shift = (0.5 - place) * vec2(cells >> (3 + 2 * nearest.x) & 1u, cells >> (1 + 6 * nearest.y) & 1u);
    vec4 hidden = vec4(0.0);
    vec4 visibility = vec4(1.0);
    const uvec4 SHIFTS = uvec4(0u, 1u, 3u, 4u);
    uvec4 bits = uvec4(notEqual(uvec4(cells) >> SHIFTS & ALL_QUADRANTS, uvec4(0u))) << uvec4(0u, 1u, 2u, 3u);
    for (uint left = bits.x | bits.y | bits.z | bits.w; left != 0u; left &= left - 1u)
    {
        int quadrant = findLSB(left);
        ivec2 sides = ivec2(quadrant & 1, quadrant >> 1);
        vec4 entry = 1.0 - entryOf(patternOf(cells, sides), mix(1.0 - place, place, vec2(sides)), firstLine);
        vec4 own = vec4(equal(ivec4(quadrant), ivec4(0, 1, 2, 3)));
        visibility -= entry.x * own;
        hidden += dot(weights, own) * entry * vec4(1.0, vec2(2 * sides - 1), 1.0);
    }
    float all = dot(weights, vec4(1.0));
    vec2 sides = vec2(weights.y + weights.w - weights.x - weights.z, weights.z + weights.w - weights.x - weights.y);
    return Quadrants(OPEN_QUADRANT * (vec4(all, sides, all) - hidden), visibility, difference - 128.0 / 255.0, shift);
}
