#pragma once

#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** The barycentric coordinates of the point of a triangle nearest to `point` (Ericson, Real-Time Collision Detection,
 * 5.1.5). Corners may coincide. May be called from any thread. */
inline glm::dvec3 findNearestPoint(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& point)
{
    // Corners may coincide, once they are rounded to floats: no edge is asked that has no length.
    const auto& [a, b, c] = corners;
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double d1 = glm::dot(ab, point - a);
    const double d2 = glm::dot(ac, point - a);
    if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};

    const double d3 = glm::dot(ab, point - b);
    const double d4 = glm::dot(ac, point - b);
    if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};

    const double shareC = d1 * d4 - d3 * d2;
    if (shareC <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3)
    {
        const double v = d1 / (d1 - d3);
        return {1.0 - v, v, 0.0};
    }

    const double d5 = glm::dot(ab, point - c);
    const double d6 = glm::dot(ac, point - c);
    if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};

    const double shareB = d5 * d2 - d1 * d6;
    if (shareB <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6)
    {
        const double w = d2 / (d2 - d6);
        return {1.0 - w, 0.0, w};
    }

    const double shareA = d3 * d6 - d5 * d4;
    if (shareA <= 0.0 && d4 >= d3 && d5 >= d6 && (d4 > d3 || d5 > d6))
    {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - w, w};
    }

    const double sum = shareA + shareB + shareC;
    return sum > 0.0 ? glm::dvec3(shareA, shareB, shareC) / sum : glm::dvec3(1.0, 0.0, 0.0);
}

} // namespace osgLego
