// The colour of a palette for a brick. The class PaletteLookup does the same on the CPU; all numbers are integers, so the
// results are equal.

#include "osgLego/palette/Dither.h"

// The indices of two colours of the palette, and the share of bricks that have the second one out of 256, as fractions of
// 255; the share is 0 if colours between those of the palette are not imitated.
uniform sampler3D paletteTable;
uniform sampler2D paletteColors;

// The colour, 0 to 255 per channel, for a cell whose surface has a colour.
ivec3 paletteColor(ivec3 color, ivec3 cell)
{
    vec3 entry = texelFetch(paletteTable, color * textureSize(paletteTable, 0) / 256, 0).rgb;
    ivec3 mixture = ivec3(255.0 * entry + 0.5);
    uint threshold = thresholdAt(uint(cell.x), uint(cell.y), uint(cell.z));
    int index = threshold < uint(mixture.b) ? mixture.g : mixture.r;
    return ivec3(255.0 * texelFetch(paletteColors, ivec2(index, 0), 0).rgb + 0.5);
}
