// The colour of each cell out of those that triangles contribute to it: the nearest to their mean, since it has the least
// depth. The classes DominantColors and TriangleColor do the same on the CPU.

#define WEIGHTED_COLORS

flat in uvec2 packedCell;

uniform sampler2D sums; // of exact voxelization

#include "passes/addressing.glsl"
#include "passes/voxel_color.glsl"
#include "voxelization/color_in_cell.glsl"
#include "gl/fragment_outputs.glsl"

// Nearer colours are hardly better: they differ by less than the preference for dark colours.
const float CLOSE = RED_BIAS + GREEN_BIAS + BLUE_BIAS;

// How well a colour stands for a mean; the lower, the better.
float dominanceScore(vec3 color, vec3 mean)
{
    return distance(color, mean) + dot(color, vec3(RED_BIAS, GREEN_BIAS, BLUE_BIAS));
}

// The texels of a triangle at one level, as numbers. The rectangle is the triangle's: others may belong to other surfaces.
struct PlainTexels
{
    int level;
    vec2 size;
    vec2 first;
    vec2 last;
    float mixtureCost; // less than 1 where a cell is less than four texels wide: there, texels may be what the picture shows
};

PlainTexels plainTexels(SurfacePoint point)
{
    ivec2 size = textureSize(surfaceTexture, 0);
    // Texels of a sixteenth of a cell: small enough for pure colours, and large enough to be typical of the cell.
    int level = clamp(int(point.level) - 3, 0, findMSB(max(size.x, size.y)));
    vec2 levelSize = vec2(max(size >> level, 1));
    const float ROUNDING = 0.01; // coordinates of a border between texels may be beyond it
    vec2 last = max(ceil(point.highest * levelSize - ROUNDING) - 1.0, floor(point.lowest * levelSize));
    vec2 first = min(floor(point.lowest * levelSize + ROUNDING), last);
    return PlainTexels(level, levelSize, first, last, clamp(point.level, 0.0, 1.0));
}

// At the centre of a texel, it is not mixed with others.
vec3 texelColor(SurfacePoint point, PlainTexels texels, vec2 texel)
{
    return surfaceColor(point.color, (texel + 0.5) / texels.size, float(texels.level));
}

// How much a colour is a mixture of two others: twice its distance from the nearer one if it lies between both, so that
// the nearer one stands better for an area of any mixture.
float mixtureOf(vec3 color, vec3 a, vec3 b)
{
    float toA = distance(color, a);
    float toB = distance(color, b);
    float detour = toA + toB - distance(a, b);
    return 2.0 * max(0.0, min(toA, toB) - detour);
}

// How much a texel is a mixture of its neighbours, as on a border between colours.
float texelMixture(SurfacePoint point, PlainTexels texels, vec2 texel, vec3 color)
{
    if (texels.mixtureCost == 0.0) return 0.0;
    const vec2 RIGHT = vec2(1.0, 0.0);
    const vec2 UP = vec2(0.0, 1.0);
    float across = mixtureOf(color, texelColor(point, texels, texel - RIGHT), texelColor(point, texels, texel + RIGHT));
    float up = mixtureOf(color, texelColor(point, texels, texel - UP), texelColor(point, texels, texel + UP));
    return texels.mixtureCost * max(across, up);
}

// The colour of one texel: of five in the cell, the nearest one to the filtered colour; mixtures count as farther away.
vec3 plainColor(SurfacePoint point)
{
    const vec2 OFFSETS[5] =
        vec2[](vec2(0.0), vec2(1.0, 1.0), vec2(1.0, -1.0), vec2(-1.0, 1.0), vec2(-1.0, -1.0)); // quarters of a cell
    if (textureEnvironment == 0) return point.color;
    vec3 filtered = filteredColor(point);
    vec2 quarter = 0.5 * exp2(point.level) / vec2(textureSize(surfaceTexture, 0));
    PlainTexels texels = plainTexels(point);
    vec3 nearest = vec3(0.0);
    float best = 1e9;
    vec2 previous = vec2(0.0);
    for (int number = 0; number < 5; ++number)
    {
        vec2 texel = floor((point.coordinate + OFFSETS[number] * quarter) * texels.size);
        texel = clamp(texel, texels.first, texels.last);
        if (number > 0 && texel == previous) continue;
        previous = texel;
        vec3 color = texelColor(point, texels, texel);
        float score = dominanceScore(color, filtered);
        if (score >= best) continue;
        float mixture = texelMixture(point, texels, texel, color);
        if (score + mixture < best) nearest = color;
        best = min(best, score + mixture);
        if (distance(color, filtered) + mixture < CLOSE) break; // as in most cells
    }
    return nearest;
}

void main()
{
    ivec3 cell = ivec3(packedCell.x & 0xffffu, packedCell.x >> 16, packedCell.y);
    vec3 color = plainColor(pointInCell(vec3(cell + firstCell) + 0.5));
    vec3 mean = colorOfVoxel(texelFetch(sums, ivec2(gl_FragCoord.xy), 0));
    gl_FragDepth = 0.5 * dominanceScore(color, mean); // a score is below 2
    fragmentColor = vec4(color, 1.0);
}
