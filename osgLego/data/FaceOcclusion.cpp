#include <osgLego/data/FaceOcclusion.h>

#include <osgLego/BrickModel.h>
#include <osgLego/data/FaceRay.h>
#include <osgLego/data/ForEachVoxel.h>
#include <osgLego/data/OcclusionCurve.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

/** The voxels in front of open faces: bits of BrickSide, by place. */
std::vector<std::uint8_t> findFaces(const VoxelGrid& grid, std::span<const BrickPoint> points)
{
    std::vector<std::uint8_t> faces(grid.getNumVoxels(), 0);
    forEachOpenFace(points, [&](const glm::ivec3& cell, int side)
                    { faces[grid.getPlace(cell + VoxelGrid::BORDER)] |= static_cast<std::uint8_t>(1 << side); });
    return faces;
}

class FaceOcclusion
{
public:
    FaceOcclusion(const VoxelGrid& grid, std::span<const BrickPoint> points, double reach) :
        _grid(grid), _faces(findFaces(grid, points)), _rays(createFaceRays(grid, reach, reach))
    {
    }

    /** Find the light that is hidden from the faces behind a voxel, and from the planes of those beside it.
     * @return the bits of the parts that it has. */
    unsigned int find(const glm::ivec3& voxel, OcclusionVolume::Light& light) const
    {
        const std::size_t place = _grid.getPlace(voxel);
        if (_grid.isCovered(place)) return 0;
        Sums sums;
        for (int side = 0; side < NUM_SIDES; side += 2)
        {
            const int faces = _faces[place] >> side & 3;
            for (const int each : {side, side + 1})
                if (faces != 0 ? (faces >> (each - side) & 1) != 0 : isBesideFace(place, each))
                    castRays(voxel, each, sums);
        }
        if (sums.numFaces == 0.0f) return 0;
        light.mean = sums.mean / glm::max(sums.meanCount, 1.0f);
        for (int axis = 0; axis < 3; ++axis)
            light.mean[axis] = static_cast<float>(OcclusionCurve::encode(light.mean[axis]));
        light.bend = sums.bend / glm::max(sums.bendCount, 1.0f);
        light.distant = sums.distant / sums.numFaces;
        unsigned int parts = 1u << OcclusionVolume::DISTANT;
        for (int axis = 0; axis < 3; ++axis)
        {
            if (sums.meanCount[axis] > 0.0f) parts |= 1u << (OcclusionVolume::MEAN + axis);
            if (sums.bendCount[axis] > 0.0f) parts |= 1u << (OcclusionVolume::BEND + axis);
        }
        return parts;
    }

private:
    /** The sums of Light over the faces of a voxel. */
    struct Sums
    {
        glm::vec3 mean{0.0f};
        glm::vec3 meanCount{0.0f};
        glm::vec3 bend{0.0f};
        glm::vec3 bendCount{0.0f};
        float distant = 0.0f;
        float numFaces = 0.0f;
    };

    /** Whether a face beside an empty voxel, in the same plane, looks to a side. */
    bool isBesideFace(std::size_t place, int side) const
    {
        glm::ivec3 first(0);
        glm::ivec3 second(0);
        first[(side / 2 + 1) % 3] = 1;
        second[(side / 2 + 2) % 3] = 1;
        const std::ptrdiff_t along = _grid.getOffset(first);
        const std::ptrdiff_t across = _grid.getOffset(second);
        const auto hasFace = [&](std::ptrdiff_t offset)
        { return (_faces[place + static_cast<std::size_t>(offset)] >> side & 1) != 0; };
        const auto isEmpty = [&](std::ptrdiff_t offset)
        { return !_grid.isCovered(place + static_cast<std::size_t>(offset)); };
        if (hasFace(along) || hasFace(-along) || hasFace(across) || hasFace(-across)) return true;
        for (const std::ptrdiff_t one : {along, -along})
            for (const std::ptrdiff_t other : {across, -across})
                // Otherwise the voxel may be inside the model.
                if (hasFace(one + other) && (isEmpty(one) || isEmpty(other))) return true;
        return false;
    }

    void castRays(const glm::ivec3& voxel, int side, Sums& sums) const
    {
        const std::uint8_t* covered = _grid.getCovered() + _grid.getPlace(voxel);
        float hidden = 0.0f;
        float distant = 0.0f;
        glm::vec3 towards(0.0f);
        for (const FaceRay& ray : _rays[static_cast<std::size_t>(side)])
        {
            const FaceRay::Hit* hit = ray.findHit(voxel, covered);
            if (!hit) continue;
            hidden += hit->hidden;
            distant += hit->distant;
            towards += hit->distant * ray.getDirection();
        }
        const int axis = side / 2;
        sums.mean[axis] += hidden / static_cast<float>(NUM_FACE_RAYS);
        sums.meanCount[axis] += 1.0f;
        for (int other = (axis + 1) % 3; other != axis; other = (other + 1) % 3)
        {
            sums.bend[other] += towards[other] * BEND_OF_FACE_RAY;
            sums.bendCount[other] += 1.0f;
        }
        sums.distant += distant / static_cast<float>(NUM_FACE_RAYS);
        sums.numFaces += 1.0f;
    }

    const VoxelGrid& _grid;
    std::vector<std::uint8_t> _faces;
    FaceRays _rays;
};

} // namespace

OcclusionVolume findFaceOcclusion(const VoxelGrid& grid, std::span<const BrickPoint> points, double reach)
{
    const FaceOcclusion faces(grid, points, reach);
    OcclusionVolume volume(grid.getSize());
    forEachVoxel(grid.getSize(),
                 [&](const glm::ivec3& voxel)
                 {
                     OcclusionVolume::Light light;
                     const unsigned int parts = faces.find(voxel, light);
                     if (parts != 0) volume.set(voxel, light, parts);
                 });
    volume.fillFromNeighbors(OcclusionVolume::Neighbors::IN_PLANE,
                             [&](const glm::ivec3& voxel) { return grid.isCovered(grid.getPlace(voxel)); });
    volume.fillFromBlocks();
    return volume;
}

} // namespace osgLego
