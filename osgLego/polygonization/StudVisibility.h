// C++ and GLSL both read this file, as they do BrickDimensions.h.
#ifndef OSGLEGO_STUD_VISIBILITY_H
#define OSGLEGO_STUD_VISIBILITY_H

#include "osgLego/BrickDimensions.h"

#ifdef __cplusplus
namespace osgLego::BrickDimensions
{

inline bool isStudSeen(Real across, Real below, Real height, Real eyeWeight);
#endif

// Whether a stud can be seen at all: from far enough below, the brick that it stands on hides it. From its rim to the
// edge of that brick it is 0.5 - STUD_RADIUS across or more.
//
// across, below: the way from the middle of the stud's foot to the eye, in cells: the distance from the stud's axis,
// and how far down along it. Where eyeWeight is 0 and not 1, a direction instead. height: of the stud, in cells.
bool isStudSeen(Real across, Real below, Real height, Real eyeWeight)
{
    return height * (across + STUD_RADIUS * eyeWeight) > (0.5 - STUD_RADIUS) * below;
}

#ifdef __cplusplus

} // namespace osgLego::BrickDimensions
#endif

#endif
