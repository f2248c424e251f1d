// The pattern that imitates colours between those of a palette. C++ and GLSL both read this file, as they do
// BrickDimensions.h, and compute the same integers.
//
// The nearest colour is looked up twice: for the colour itself, and for the colour after an offset that depends on the
// cell. Offsets are no larger than four times the distance to the first result, so that colours of the palette stay
// plain. On any plane or line of cells, the offsets are spread evenly between both limits (Roberts 2018, the sequence
// R3); each channel reads the sequence along other axes, so that colours are mixed from more than two of the palette.
#ifndef OSGLEGO_DITHER_H
#define OSGLEGO_DITHER_H

#ifdef __cplusplus
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace osgLego::Dither
{

using uint = std::uint32_t;

inline uint thresholdAt(uint x, uint y, uint z);
inline int limitOffset(int amplitude, int distance);
inline int offsetChannel(int channel, int amplitude, uint threshold);
#endif

// A number from 0 to 255 for each cell.
uint thresholdAt(uint x, uint y, uint z)
{
    // 2^32 times the powers -1, -2 and -3 of the root of g^4 = g + 1. Overflow is intended.
    return (x * 3518319155u + y * 2882110345u + z * 2360945575u) >> 24u;
}

// The amplitude for a colour. distance: to the nearest colour of the palette, in the channel in which it is largest.
int limitOffset(int amplitude, int distance)
{
    return amplitude < 4 * distance ? amplitude : 4 * distance;
}

// A channel of a colour, 0 to 255, after an offset of up to half the amplitude, which is 0 to 255.
int offsetChannel(int channel, int amplitude, uint threshold)
{
    // The shift rounds down, as it does for negative numbers in both languages.
    int result = channel + ((amplitude * (2 * int(threshold) - 255) + 256) >> 9);
    return result < 0 ? 0 : result > 255 ? 255 : result;
}

#ifdef __cplusplus

using Color = std::array<std::uint8_t, 3>;

/** The colour to look up in a palette in place of `color` in a cell. @param nearest the colour of the palette nearest
 * to `color`. @param amplitude Palette::getDitherAmplitude(). */
inline Color dithered(const Color& color, const Color& nearest, const std::array<std::uint16_t, 3>& cell, int amplitude)
{
    int distance = 0;
    for (std::size_t channel = 0; channel < 3; ++channel)
        distance = std::max(distance, std::abs(color[channel] - nearest[channel]));
    const int limited = limitOffset(amplitude, distance);
    Color result;
    for (std::size_t channel = 0; channel < 3; ++channel)
        result[channel] = static_cast<std::uint8_t>(offsetChannel(
            color[channel], limited, thresholdAt(cell[channel], cell[(channel + 1) % 3], cell[(channel + 2) % 3])));
    return result;
}

} // namespace osgLego::Dither
#else

ivec3 dithered(ivec3 color, ivec3 nearest, uvec3 cell, int amplitude)
{
    ivec3 distances = abs(color - nearest);
    int limited = limitOffset(amplitude, max(distances.r, max(distances.g, distances.b)));
    return ivec3(offsetChannel(color.r, limited, thresholdAt(cell.x, cell.y, cell.z)),
                 offsetChannel(color.g, limited, thresholdAt(cell.y, cell.z, cell.x)),
                 offsetChannel(color.b, limited, thresholdAt(cell.z, cell.x, cell.y)));
}
#endif

#endif
