// The proportions of a brick. C++ and GLSL both read this file (in a shader: #include "osgLego/BrickDimensions.h"), so
// it contains only constants, in syntax that both languages accept.
//
// Lengths are relative to the pitch, the width of a cell. The pitch of a LEGO brick is 8 mm.
//
// Usage:
//
//     const double radius = osgLego::BrickDimensions::STUD_RADIUS * grid.getPitch();
#ifndef OSGLEGO_BRICK_DIMENSIONS_H
#define OSGLEGO_BRICK_DIMENSIONS_H

#ifdef __cplusplus
namespace osgLego::BrickDimensions
{

using Real = double;
#else
#define constexpr const
#define Real float
#endif

constexpr Real STUD_RADIUS = 0.3;    // 4.8 mm across
constexpr Real STUD_HEIGHT = 0.2125; // 1.7 mm
constexpr int STUD_SIDES = 16;       // of the prism that approximates the cylinder

// Below, a part is hollow: inside of its walls, tubes hold studs between four, and pins those between two.
constexpr Real WALL_THICKNESS = 0.1875; // 1.5 mm
constexpr Real TUBE_RADIUS = 0.407;     // 6.51 mm across, outside; a stud fits in
constexpr Real PIN_RADIUS = 0.2;        // 3.2 mm across

constexpr Real EDGE = 0.045; // the width of a rounded edge, 0.36 mm
constexpr Real GAP = 0.014;  // half the gap between two bricks, 0.1 mm; also the depth that light does not reach

#ifdef __cplusplus
} // namespace osgLego::BrickDimensions
#endif

#endif
