#pragma once

#include "Simd.h"

#include <array>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** Finds the point of a triangle that is nearest to a given point, for four points at a time.
 *
 * It is the nearest point of the triangle's plane if that is inside the triangle, otherwise the nearest point of its
 * edges. All four candidates are computed, since a branch between them would be mispredicted often and cost more.
 * Values that depend only on the triangle are precomputed, so that a point costs two scalar products and no division.
 *
 * shaders/voxelization/nearest_point.glsl does the same on the GPU, and explains why it uses another algorithm.
 *
 * Immutable; uses no GL. May be called from any thread.
 */
class NearestPoint
{
public:
    static constexpr std::size_t NUM_LANES = 4;
    using Lanes = DoubleLanes<NUM_LANES>;

    /** Barycentric coordinates of points for the second and third corner; that for the first is 1 - b - c. */
    struct Shares
    {
        Lanes b;
        Lanes c;
    };

    NearestPoint() = default;

    /** Corners may coincide. */
    explicit NearestPoint(const std::array<glm::vec3, 3>& corners) :
        _corner(corners[0]), _ab(glm::dvec3(corners[1]) - _corner), _ac(glm::dvec3(corners[2]) - _corner),
        _abab(glm::dot(_ab, _ab)), _abac(glm::dot(_ab, _ac)), _acac(glm::dot(_ac, _ac)), _perAb(inverse(_abab)),
        _perAc(inverse(_acac)), _perBc(inverse(_abab - 2.0 * _abac + _acac)), _perArea(inverseArea())
    {
    }

    /** The points nearest to the points (x, y, z). */
    Shares find(const Lanes& x, const Lanes& y, const Lanes& z) const
    {
        const Lanes px = x - _corner.x;
        const Lanes py = y - _corner.y;
        const Lanes pz = z - _corner.z;
        const Lanes ab = _ab.x * px + _ab.y * py + _ab.z * pz;
        const Lanes ac = _ac.x * px + _ac.y * py + _ac.z * pz;

        // The nearest point on each edge, as a fraction of its length, and its squared distance minus that of corner a.
        const Lanes alongAb = clamped(ab * _perAb);
        const Lanes alongAc = clamped(ac * _perAc);
        const Lanes alongBc = clamped((ac - ab + (_abab - _abac)) * _perBc);
        const Lanes b = 1.0 - alongBc;
        const Lanes toAb = alongAb * (alongAb * _abab - 2.0 * ab);
        const Lanes toAc = alongAc * (alongAc * _acac - 2.0 * ac);
        const Lanes toBc =
            b * (b * _abab - 2.0 * ab) + alongBc * (alongBc * _acac - 2.0 * ac) + 2.0 * _abac * b * alongBc;

        Shares shares{alongAb, 0.0};
        const Lanes::mask_type isOnAc = toAc < toAb;
        where(isOnAc, shares.b) = 0.0;
        where(isOnAc, shares.c) = alongAc;
        const Lanes::mask_type isOnBc = toBc < toAb && toBc < toAc;
        where(isOnBc, shares.b) = b;
        where(isOnBc, shares.c) = alongBc;

        const Lanes insideB = (_acac * ab - _abac * ac) * _perArea;
        const Lanes insideC = (_abab * ac - _abac * ab) * _perArea;
        const Lanes::mask_type isInside = insideB > 0.0 && insideC > 0.0 && insideB + insideC < 1.0;
        where(isInside, shares.b) = insideB;
        where(isInside, shares.c) = insideC;
        return shares;
    }

private:
    static Lanes clamped(const Lanes& lanes) { return min(max(lanes, Lanes(0.0)), Lanes(1.0)); }

    static double inverse(double value) { return value > 0.0 ? 1.0 / value : 0.0; }

    double inverseArea() const
    {
        // In a sliver narrower than this, an edge is as near, and rounding errors dominate the area.
        constexpr double NARROWEST = 1e-12;
        const double area = _abab * _acac - _abac * _abac;
        return area > NARROWEST * _abab * _acac ? 1.0 / area : 0.0;
    }

    glm::dvec3 _corner{0.0};
    glm::dvec3 _ab{0.0};
    glm::dvec3 _ac{0.0};
    double _abab = 0.0;
    double _abac = 0.0;
    double _acac = 0.0;
    double _perAb = 0.0;
    double _perAc = 0.0;
    double _perBc = 0.0;
    double _perArea = 0.0;
};

} // namespace osgLego
