#pragma once

#include <cmath>

namespace osgLego
{

/** The curve along which occlusion is interpolated between the middles of faces: it decreases with the distance from a
 * step nearly exponentially. */
struct OcclusionCurve
{
    static constexpr double OFFSET = 0.02; //!< of the hidden fraction, as it may be 0

    /** @param hidden a fraction, 0 to 1. @return 0 to 1. */
    static double encode(double hidden) { return std::log1p(hidden / OFFSET) / std::log1p(1.0 / OFFSET); }
    static double decode(double code) { return OFFSET * std::expm1(code * std::log1p(1.0 / OFFSET)); }
};

} // namespace osgLego
