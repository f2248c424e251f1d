// The colour of a palette for a brick. The class PaletteLookup does the same on the CPU; all numbers are integers, so the
// results are equal.

#include "osgLego/palette/Dither.h"

uniform sampler3D paletteTable; // the index of the nearest colour of the palette, as a fraction of 255
uniform sampler2D paletteColors;
uniform int ditherAmplitude; // 0 if colours between those of the palette are not imitated

ivec3 nearestColor(ivec3 color)
{
    int index = int(255.0 * texelFetch(paletteTable, color * textureSize(paletteTable, 0) / 256, 0).r + 0.5);
    return ivec3(255.0 * texelFetch(paletteColors, ivec2(index, 0), 0).rgb + 0.5);
}

// The colour, 0 to 255 per channel, for a cell whose surface has a colour.
ivec3 paletteColor(ivec3 color, ivec3 cell)
{
    ivec3 nearest = nearestColor(color);
    return ditherAmplitude > 0 ? nearestColor(dithered(color, nearest, uvec3(cell), ditherAmplitude)) : nearest;
}
