// Near occlusion of bricks by the cells around them (see createOcclusionTable and BrickNeighbors): exact but for the cells that are
// left out, without noise, and independent of the view.

uniform usamplerBuffer neighbors; // three texels for each brick
uniform int numNeighbors;         // of bricks; others count as alone
uniform sampler2D occlusionTable; // in quarters: faces on top and below, those at the sides; likewise, differences

const float TABLE_SIDE = 8.0; // texels of a pattern
const int PATTERNS_ACROSS = 64;
// The values of an open quadrant: visibility, and the bent vector along the face and along its normal.
const vec4 OPEN_QUADRANT = vec4(0.25, 0.106103295, 0.106103295, 0.166666667);
// The words of BrickNeighbors that concern a face.
struct FaceNeighbors
{
    uint near; // 20 bits: the cells beside the edges and at the corners of the brick
    uint far;  // 18 bits: the second and third layer in front of the face
};

FaceNeighbors neighborsOf(int number, uint open, int side)
{
    int first = 3 * number;
    uint numBefore = uint(bitCount(open & ((1u << side) - 1u)));
    bool hasThird = bitCount(open) < 5;
    int place = 20 + int(numBefore) * (hasThird ? 18 : 9);
    int word = place >> 5;
    int shift = place & 31;
    uint lower = texelFetch(neighbors, first + word).x;
    uint upper = texelFetch(neighbors, first + min(word + 1, 2)).x;
    uint far = lower >> shift | (shift == 0 ? 0u : upper << (32 - shift));
    return FaceNeighbors(texelFetch(neighbors, first).x & 0xfffffu, far & (hasThird ? 0x3ffffu : 0x1ffu));
}

// The place in BrickNeighbors of the cell beside an edge: the one on two sides.
int edgeBit(int axis, int upper, int other, int otherUpper)
{
    int along = 3 - axis - other;
    return 4 * along + (axis == (along + 1) % 3 ? upper + 2 * otherUpper : otherUpper + 2 * upper);
}

// The pattern of the cells of a quadrant. `sides` are 1 for the upper ends of the axes along the face.
uint patternOf(FaceNeighbors cells, int axis, int upper, ivec2 axes, ivec2 sides)
{
    ivec2 strides = axes.x == (axis + 1) % 3 ? ivec2(1, 3) : ivec2(3, 1);
    ivec2 steps = (2 * sides - 1) * strides;
    int corner = 12 + (upper << axis) + (sides.x << axes.x) + (sides.y << axes.y);
    uint pattern = (cells.near >> edgeBit(axis, upper, axes.x, sides.x) & 1u) |
                   (cells.near >> edgeBit(axis, upper, axes.y, sides.y) & 1u) << 1 | (cells.near >> corner & 1u) << 2;
    uvec4 second = uvec4(cells.far >> 4, cells.far >> (4 + steps.x), cells.far >> (4 + steps.y),
                         cells.far >> (4 + steps.x + steps.y));
    uvec4 bits = second & 1u;
    pattern |= bits.x << 3 | bits.y << 4 | bits.z << 5 | bits.w << 6;
    bits = second >> 9 & 1u;
    return pattern | bits.x << 7 | bits.y << 8 | bits.z << 9 | bits.w << 10;
}

// An entry of the table. `position` is 0 to 1, `firstLine` that of a quarter.
vec4 entryOf(uint pattern, vec2 position, float firstLine)
{
    vec2 block = vec2(float(pattern & uint(PATTERNS_ACROSS - 1)), float(pattern / uint(PATTERNS_ACROSS)));
    vec2 texel = block * TABLE_SIDE + 0.5 + clamp(position, 0.0, 1.0) * (TABLE_SIDE - 1.0) + vec2(0.0, firstLine);
    return textureLod(occlusionTable, texel / vec2(textureSize(occlusionTable, 0)), 0.0);
}

// The visibility and the bent vector of a quadrant.
vec4 quadrantAt(uint pattern, ivec2 sides, vec2 place, float firstLine)
{
    vec4 entry = entryOf(pattern, mix(1.0 - place, place, vec2(sides)), firstLine) * OPEN_QUADRANT;
    return vec4(entry.x, entry.yz * vec2(2 * sides - 1), entry.w);
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
Quadrants findQuadrants(FaceNeighbors cells, int axis, bool isUpper, ivec2 axes, vec2 place, vec4 weights, bool isLevel)
{
    int upper = int(isUpper);
    float quarter = 0.25 * float(textureSize(occlusionTable, 0).y);
    float firstLine = isLevel ? 0.0 : quarter;
    uvec4 patterns = uvec4(patternOf(cells, axis, upper, axes, ivec2(0, 0)), patternOf(cells, axis, upper, axes, ivec2(1, 0)),
                           patternOf(cells, axis, upper, axes, ivec2(0, 1)), patternOf(cells, axis, upper, axes, ivec2(1, 1)));
    vec4 first = quadrantAt(patterns.x, ivec2(0, 0), place, firstLine);
    vec4 second = quadrantAt(patterns.y, ivec2(1, 0), place, firstLine);
    vec4 third = quadrantAt(patterns.z, ivec2(0, 1), place, firstLine);
    vec4 last = quadrantAt(patterns.w, ivec2(1, 1), place, firstLine);
    // The quarter of the face in which the place is.
    uvec2 nearest = place.y < 0.5 ? patterns.xy : patterns.zw;
    uint pattern = place.x < 0.5 ? nearest.x : nearest.y;
    float difference = entryOf(pattern, abs(2.0 * place - 1.0), firstLine + 2.0 * quarter).x;
    // There is nothing to interpolate with in a covered cell beside the face.
    vec2 shift = (0.5 - place) * vec2(pattern & 1u, pattern >> 1 & 1u);
    return Quadrants(weights.x * first + weights.y * second + weights.z * third + weights.w * last,
                     vec4(first.x, second.x, third.x, last.x) / OPEN_QUADRANT.x, difference - 128.0 / 255.0, shift);
}
