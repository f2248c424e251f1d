// The pattern in which bricks of two colours imitate a colour between them. C++ and GLSL both read this file, as they
// do BrickDimensions.h, and compute the same integers.
//
// A cell has the second colour if its threshold is below the share of that colour. On any plane or line of cells,
// thresholds are spread evenly (Roberts 2018, the sequence R3), so that even a few cells have about the right share.
#ifndef OSGLEGO_DITHER_H
#define OSGLEGO_DITHER_H

#ifdef __cplusplus
#include <cstdint>

namespace osgLego::Dither
{

using uint = std::uint32_t;

inline uint thresholdAt(uint x, uint y, uint z);
#endif

// A number from 0 to 255 for each cell.
uint thresholdAt(uint x, uint y, uint z)
{
    // 2^32 times the powers -1, -2 and -3 of the root of g^4 = g + 1. Overflow is intended.
    return (x * 3518319155u + y * 2882110345u + z * 2360945575u) >> 24u;
}

#ifdef __cplusplus
} // namespace osgLego::Dither
#endif

#endif
