// Constants that the CPU's way to find bricks and the passes of the GPU share. C++ and GLSL both read this file, as
// they do BrickDimensions.h.
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

// Added to the area of a triangle in a cell, in cells squared: lets one that only grazes the cell decide its colour
// when no other covers it.
constexpr Real LEAST_WEIGHT = 1e-9;

// The texture level that a fraction of 1 stands for in a packed vertex.
constexpr Real MAXIMUM_LEVEL = 16.0;

#ifdef __cplusplus
} // namespace osgLego::PassConstants
#endif

#endif
