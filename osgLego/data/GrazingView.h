#pragma once

#include <cmath>

namespace osgLego
{

/** Whether a face is seen edge-on or at so flat an angle that no part is found by it.
 * @param cosine that of the angle between the normal of the face and the direction to the eye. */
inline bool isGrazing(double cosine)
{
    constexpr double LEAST_COSINE = 0.1; // about six degrees
    return std::abs(cosine) < LEAST_COSINE;
}

} // namespace osgLego
