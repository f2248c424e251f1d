// Included from both C++ and GLSL, like BrickDimensions.h.
#ifndef OSGLEGO_STUD_VISIBILITY_H
#define OSGLEGO_STUD_VISIBILITY_H

#include "osgLego/BrickDimensions.h"

#ifdef __cplusplus
namespace osgLego::BrickDimensions
{

inline bool isStudSeen(Real across, Real below, Real height, Real eyeWeight);
#endif

// Whether a stud can be visible: from far enough below, its own brick hides it. The distance from the stud's rim to the
// edge of the brick is at least 0.5 - STUD_RADIUS.
//
// across, below: the vector from the centre of the stud's foot to the eye, in cells: the distance from the stud's axis,
// and the downward component along it. If eyeWeight is 0 instead of 1, they are a direction. height: the stud's height,
// in cells.
bool isStudSeen(Real across, Real below, Real height, Real eyeWeight)
{
    return height * (across + STUD_RADIUS * eyeWeight) > (0.5 - STUD_RADIUS) * below;
}

#ifdef __cplusplus

} // namespace osgLego::BrickDimensions
#endif

#endif
