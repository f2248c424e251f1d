#pragma once

#include <osgLego/data/VoxelGrid.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

/** The voxels that a ray passes after its first one, nearest first. It is the same for every first voxel. */
class OcclusionPath
{
public:
    struct Step
    {
        glm::ivec3 voxel; // relative to the first
        double distance;  // at which the ray enters the voxel, in pitches
    };

    /** @param origin in the first voxel, from its corner, in pitches. @param direction of length 1.
     * @param reach the length of the ray, in pitches. */
    OcclusionPath(const VoxelGrid& grid, const glm::dvec3& origin, const glm::dvec3& direction, double reach);

    const glm::vec3& getDirection() const { return _direction; }
    const std::vector<Step>& getSteps() const { return _steps; }

    /** The index of the first step to a voxel with bricks, if there is one.
     * @param covered VoxelGrid::getCovered() from the first voxel on. @param first the first step that counts. */
    std::optional<std::size_t> findHit(const std::uint8_t* covered, std::size_t first = 0) const
    {
        for (std::size_t step = first; step < _offsets.size(); ++step)
            if (covered[_offsets[step]] != 0) return step;
        return {};
    }

    /** The first step to a voxel without bricks, from a step on; the number of steps if there is none. */
    std::size_t findGap(const std::uint8_t* covered, std::size_t first) const
    {
        while (first < _offsets.size() && covered[_offsets[first]] != 0)
            ++first;
        return first;
    }

private:
    glm::vec3 _direction;
    std::vector<Step> _steps;
    std::vector<std::int32_t> _offsets; // of the voxels, from the first one
};

/** Directions that are evenly distributed over the sphere, by Fibonacci's lattice. */
std::vector<glm::dvec3> createSphere(int numDirections);
/** Directions of the hemisphere above the last axis, cosine-weighted, by the same lattice. */
std::vector<glm::dvec3> createHemisphere(int numDirections);

} // namespace osgLego
