// Included from both C++ and GLSL, like BrickDimensions.h.
#ifndef OSGLEGO_FADED_COLOR_H
#define OSGLEGO_FADED_COLOR_H

#include "osgLego/BrickDimensions.h"

#ifdef __cplusplus
namespace osgLego::FadedColor
{

using BrickDimensions::Real;
#endif

// The colour (sRGB, 0 to 1) that faded parts are mixed with, and its share. No colour of the built-in palette becomes
// similar to another one, or to itself: with a lighter grey and a smaller share, black looked light grey.
constexpr Real FADED_RED = 0.80;
constexpr Real FADED_GREEN = 0.83;
constexpr Real FADED_BLUE = 0.86;
constexpr Real FADING = 0.75;

#ifdef __cplusplus
} // namespace osgLego::FadedColor
#endif

#endif
