#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <osgLego/BrickModel.h>
#include <vector>

#include <glm/vec3.hpp>
#include <osg/Vec3d>
#include <osg/ref_ptr>

namespace osgLego
{

/** Casts rays at bricks as they are drawn, boxes and sixteen-sided studs: for ambient occlusion and other light that
 * is worked out on the CPU.
 *
 * Points and distances are in pitches from the origin of the grid (toCaster): along the model's axes, a cell is 1 wide,
 * 1 deep, and as high as its proportions say. Directions are those of the model.
 *
 * Usage:
 *
 *     const osgLego::BrickRayCaster caster(*model);
 *     const glm::dvec3 point = caster.toCaster(surfacePoint);
 *     const auto occlusion = caster.sampleOcclusion(point, normal, 8.0, 0.5, 64, seed);
 *     if (const auto distance = caster.findNearest(point + 1e-4 * normal, toLight, 100.0)) ... // in the shade
 *
 * Preconditions:
 * 1. A cell of the model is at least as high as a stud, as the cells of all Proportions are.
 * 2. Directions and normals have length 1, points are finite.
 *
 * Free of GL, immutable once created; every function may be called from any thread. Besides 16 bytes for each block of
 * 4 x 4 x 4 cells with a brick or a stud in it, it keeps 4 bytes for every block of the grid: 64 MiB at 1024 cells a
 * side.
 */
class BrickRayCaster
{
public:
    /** How much of the hemisphere above a point is open. */
    struct Occlusion
    {
        double visibility = 1.0;    //!< its cosine-weighted open share, 0 to 1
        glm::dvec3 bentNormal{0.0}; //!< the mean, cosine-weighted, open direction, of length 1
    };

    explicit BrickRayCaster(const BrickModel& model);

    const BrickModel& getModel() const { return *_model; }
    /** The length of a pitch: a distance of the caster times this is one in model units. */
    double getPitch() const { return _model->getGrid().getPitch(); }
    /** From model units to pitches. */
    glm::dvec3 toCaster(const osg::Vec3d& point) const;

    /** How far along a ray the first brick or stud is; 0 for a ray that starts inside of one.
     *
     * Cells are half-open, as in BrickGrid: to leave a surface, start a little above it.
     * @param maximumDistance 0 to infinity, itself included.
     * @return nothing when there is none up to `maximumDistance`. */
    std::optional<double> findNearest(const glm::dvec3& origin, const glm::dvec3& direction,
                                      double maximumDistance) const;

    /** Cast rays from a point of a surface, spread evenly over the cosine-weighted hemisphere.
     *
     * A hit at distance t shuts off clamp((radius - t) / (radius * falloff), 0, 1) of its ray. Starts 1e-4 above the
     * surface; the same arguments give the same result.
     * @param radius above 0; nothing farther away counts.
     * @param falloff above 0, up to 1: the outer part of the radius over which hits fade.
     * @param numRays at least 1.
     * @param seed turns the set of rays; give neighbouring points different ones.
     * @return the normal itself as bent normal where everything is shut. */
    Occlusion sampleOcclusion(const glm::dvec3& point, const glm::dvec3& normal, double radius, double falloff,
                              int numRays, std::uint32_t seed) const;

private:
    /** 4 x 4 x 4 cells, a bit each: those covered, and those empty but for a stud on their bottom. */
    struct Block
    {
        std::uint64_t covered = 0;
        std::uint64_t studs = 0;
    };

    std::size_t placeOf(const glm::ivec3& cell) const;
    Block& addBlock(const glm::ivec3& cell);
    std::optional<double> findStud(const glm::ivec3& cell, const glm::dvec3& origin, const glm::dvec3& direction,
                                   double maximumDistance) const;

    osg::ref_ptr<const BrickModel> _model;
    int _up;
    glm::dvec3 _cellExtent;                   // of a cell, in pitches
    glm::ivec3 _dimensions;                   // in cells, with a layer for the studs on the topmost bricks
    glm::ivec3 _blockCounts;                  // along each axis
    std::vector<std::uint32_t> _blockNumbers; // of every block of the grid, its place in _blocks
    std::vector<Block> _blocks;               // the first is empty, and stands for all empty ones
};

} // namespace osgLego
