#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/SparseBox.h>

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>
#include <osg/Vec3d>
#include <osg/ref_ptr>

namespace osgLego
{

/** Casts rays at bricks as they are drawn, boxes with sixteen-sided studs: for ambient occlusion and other lighting
 * that is computed on the CPU.
 *
 * Points and distances are in pitches from the origin of the grid (see toCaster): along the model's axes, a cell is 1
 * wide, 1 deep, and 1, 1.2 or 0.4 high, depending on its Proportions. Directions are in model coordinates.
 *
 * Usage:
 *
 *     const osgLego::BrickRayCaster caster(*model);
 *     const glm::dvec3 point = caster.toCaster(surfacePoint);
 *     const auto occlusion = caster.sampleOcclusion(point, normal, 8.0, 0.5, 64, seed);
 *     if (const auto distance = caster.findNearest(point + 1e-4 * normal, toLight, 100.0)) ... // in the shade
 *
 * Preconditions:
 * 1. Cells of the model are at least as high as a stud. All Proportions satisfy this.
 * 2. Directions and normals have length 1; points are finite.
 *
 * Needs no GL context. Immutable once created; every function may be called from any thread. Memory follows the number
 * of bricks: 64 KiB for each block of 64 x 64 x 64 cells that contains some.
 */
class BrickRayCaster
{
public:
    /** How much of the hemisphere above a point is open. */
    struct Occlusion
    {
        double visibility = 1.0;    //!< its cosine-weighted open fraction, 0 to 1
        glm::dvec3 bentNormal{0.0}; //!< the cosine-weighted mean of the open directions, of length 1
    };

    explicit BrickRayCaster(const BrickModel& model);

    const BrickModel& getModel() const { return *_model; }
    /** The length of a pitch, in model units. */
    double getPitch() const { return _model->getGrid().getPitch(); }
    /** From model units to pitches. */
    glm::dvec3 toCaster(const osg::Vec3d& point) const;

    /** The distance along a ray to the first brick or stud; 0 for a ray that starts inside one.
     *
     * Cells are half-open, as in BrickGrid: a ray that leaves a surface must start slightly above it.
     * @param maximumDistance 0 to infinity, inclusive.
     * @return empty if the ray hits nothing up to `maximumDistance`. */
    std::optional<double> findNearest(const glm::dvec3& origin, const glm::dvec3& direction,
                                      double maximumDistance) const;

    /** Cast rays from a point on a surface, distributed evenly over the cosine-weighted hemisphere.
     *
     * A hit at distance t blocks the fraction clamp((radius - t) / (radius * falloff), 0, 1) of its ray. Rays start
     * 1e-4 above the surface. The same arguments give the same result.
     * @param radius above 0; hits farther away are ignored.
     * @param falloff above 0, up to 1: the outer fraction of the radius over which hits fade.
     * @param numRays at least 1.
     * @param seed rotates the set of rays; give neighbouring points different seeds.
     * @return if every ray is blocked, the bent normal is the normal itself. */
    Occlusion sampleOcclusion(const glm::dvec3& point, const glm::dvec3& normal, double radius, double falloff,
                              int numRays, std::uint32_t seed) const;

private:
    /** 4 x 4 x 4 cells, one bit each: covered cells, and cells that contain only the stud of the brick below. */
    struct Block
    {
        std::uint64_t covered = 0;
        std::uint64_t studs = 0;
    };

    std::optional<double> findStud(const glm::ivec3& cell, const glm::dvec3& origin, const glm::dvec3& direction,
                                   double maximumDistance) const;

    osg::ref_ptr<const BrickModel> _model;
    int _up;
    glm::dvec3 _cellExtent; // the size of a cell, in pitches
    glm::ivec3 _dimensions; // in cells, with a layer for the studs on the topmost bricks
    SparseBox<Block> _blocks;
};

} // namespace osgLego
