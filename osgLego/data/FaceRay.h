#pragma once

#include <osgLego/data/OcclusionPath.h>
#include <osgLego/data/OpenFaces.h>
#include <osgLego/data/VoxelGrid.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace osgLego
{

constexpr int NUM_FACE_RAYS = 48;
/** Hidden rays, as a vector in which each has the length of its hidden fraction, times this are `bend` of
 * OcclusionVolume::Light. Bent normals move by the part 0.5625 of it (shaders/light/distant_light.glsl), and the mean
 * open direction of an open hemisphere is two thirds as long as its normal. */
constexpr float BEND_OF_FACE_RAY = 1.0f / (0.5625f * (2.0f / 3.0f) * static_cast<float>(NUM_FACE_RAYS));

/** A ray from the middle of a face of a brick: the cells that it passes, and the light that each may hide from the
 * face. Immutable; every function may be called from any thread. */
class FaceRay
{
public:
    /** @param cells whose voxels are cells. @param direction of length 1, away from the face. @param side of the brick.
     * @param reach the greatest distance of occluders, and @param length of the ray, up to `reach`, in pitches. */
    FaceRay(const VoxelGrid& cells, const glm::dvec3& direction, int side, double reach, double length);

    /** The light that a cell hides, if it is the first brick on the ray. */
    struct Hit
    {
        float hidden;  //!< the fraction of the ray
        float distant; //!< the part of it that near occlusion does not know
    };

    const glm::vec3& getDirection() const { return _path.getDirection(); }
    /** The cells that it passes, relative to the one in front of the face. */
    const std::vector<OcclusionPath::Step>& getSteps() const { return _path.getSteps(); }
    /** The light that the cell of a step hides. */
    const Hit& getHit(std::size_t step) const { return _hits[step]; }

    /** The first hit of a brick; null if there is none.
     * @param voxel the cell in front of the face. @param covered VoxelGrid::getCovered() from this cell on. */
    const Hit* findHit(const glm::ivec3& voxel, const std::uint8_t* covered) const
    {
        const std::optional<std::size_t> step = _path.findHit(covered, 0, _path.countStepsInside(voxel));
        return step ? &_hits[*step] : nullptr;
    }

private:
    OcclusionPath _path;
    std::vector<Hit> _hits; // by step
};

/** Rays by side. */
using FaceRays = std::array<std::vector<FaceRay>, NUM_SIDES>;

/** NUM_FACE_RAYS rays for each side, cosine-weighted; see the constructor of FaceRay. */
FaceRays createFaceRays(const VoxelGrid& cells, double reach, double length);

} // namespace osgLego
