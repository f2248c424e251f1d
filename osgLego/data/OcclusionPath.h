#pragma once

#include <osgLego/data/VoxelGrid.h>

#include <algorithm>
#include <array>
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

    /** The number of steps from a voxel until the ray leaves the grid, after which there are no bricks.
     * @param voxel of the grid or its border. */
    std::size_t countStepsInside(const glm::ivec3& voxel) const
    {
        const auto countAlong = [&](int axis)
        { return _numsInside[static_cast<std::size_t>(axis)][static_cast<std::size_t>(voxel[axis])]; };
        return std::min({countAlong(0), countAlong(1), countAlong(2)});
    }

    /** The index of the first step to a voxel with bricks, if there is one.
     * @param covered VoxelGrid::getCovered() from the first voxel on. @param first the first step that counts, and
     * @param end the one after the last. */
    std::optional<std::size_t> findHit(const std::uint8_t* covered, std::size_t first, std::size_t end) const
    {
        for (std::size_t step = first; step < end; ++step)
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
    void countSteps(const VoxelGrid& grid);

    glm::vec3 _direction;
    std::vector<Step> _steps;
    std::vector<std::int32_t> _offsets;                    // of the voxels, from the first one
    std::array<std::vector<std::uint16_t>, 3> _numsInside; // by axis, and by the first voxel along it
};

/** Directions that are evenly distributed over the sphere, by Fibonacci's lattice. */
std::vector<glm::dvec3> createSphere(int numDirections);
/** Directions of the hemisphere above the last axis, cosine-weighted, by the same lattice. */
std::vector<glm::dvec3> createHemisphere(int numDirections);

} // namespace osgLego
