#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** The colour difference CIEDE2000 of two colours in CIELAB, as Sharma, Wu and Dalal (2005) specify it: 0 for equal
 * colours, about 1 for a difference that is just noticeable, 100 for black and white. Symmetric, but not a metric: the
 * triangle inequality does not hold. May be called from any thread. */
double ciede2000(const glm::dvec3& color, const glm::dvec3& other);

/** A matrix that turns small differences from a colour, in CIELAB, into vectors whose length is about ciede2000(): in
 * lightness, chroma and hue. It ignores how chroma and hue interact in blue. */
glm::dmat3 ciede2000Scale(const glm::dvec3& color);

/** A lower bound of ciede2000() that is fast to compute: the part of it that is due to lightness. */
double lightnessDifference(const glm::dvec3& color, const glm::dvec3& other);

} // namespace osgLego
