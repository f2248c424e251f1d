// Constants that voxelization on the CPU and on the GPU share. C++ and GLSL both read this file, as they do
// BrickDimensions.h.
#ifndef OSGLEGO_PASS_CONSTANTS_H
#define OSGLEGO_PASS_CONSTANTS_H

#ifdef __cplusplus
namespace osgLego::PassConstants
{

using Real = double;
#else
#define constexpr const
#define Real float
#endif

// Added to the area of a triangle in a cell, in cells squared, so that a triangle that merely grazes the cell still
// determines its colour if no other triangle covers it.
constexpr Real LEAST_WEIGHT = 1.0 / (1 << 24);

// The voxel image of exact voxelization stores weights times WEIGHT_SCALE, and colours minus COLOR_CENTER, so that half
// floats represent LEAST_WEIGHT as a normal number, and sums of areas of up to 63 cells squared. LARGEST_SUM stands for
// infinity, the sum of larger areas.
constexpr Real WEIGHT_SCALE = 1024.0;
constexpr Real COLOR_CENTER = 0.5;
constexpr Real LARGEST_SUM = 65504.0;

// Where two colours have equal areas in a cell, the darker one is chosen: its distance from the mean is increased by
// less. That decides between colours alike in all cells along a border, where rounding errors would decide differently
// in each, and changes the areas at which the choice changes by less than 2 %.
constexpr Real RED_BIAS = 0.010;
constexpr Real GREEN_BIAS = 0.017;
constexpr Real BLUE_BIAS = 0.004;

// The mipmap levels that fractions of 0 and 1 denote in a packed vertex. Negative ones tell how small a cell is in a
// texel; 0 is a fraction that 16 bits hold exactly.
constexpr Real MINIMUM_LEVEL = -14.0;
constexpr Real MAXIMUM_LEVEL = 16.0;

#ifdef __cplusplus
} // namespace osgLego::PassConstants
#endif

#endif
