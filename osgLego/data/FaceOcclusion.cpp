#include <osgLego/data/FaceOcclusion.h>

#include <osgLego/BrickModel.h>
#include <osgLego/data/ForEachVoxel.h>
#include <osgLego/data/OcclusionCurve.h>
#include <osgLego/data/OcclusionFalloff.h>
#include <osgLego/data/OcclusionPath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr int NUM_SIDES = 6; // in the order of BrickSide
constexpr int NUM_DIRECTIONS = 48;

/** The steps that a face takes along its side's normal. */
glm::ivec3 getNormal(int side)
{
    glm::ivec3 normal(0);
    normal[side / 2] = side % 2 == 0 ? -1 : 1;
    return normal;
}

/** Whether the near occlusion of the grid knows a cell. @param cell relative to the one in front of a face. */
bool isKnown(const glm::ivec3& cell, int axis)
{
    constexpr int NUM_LAYERS = 3;
    const glm::ivec3 away = glm::abs(cell);
    return away[axis] < NUM_LAYERS && away[(axis + 1) % 3] <= 1 && away[(axis + 2) % 3] <= 1;
}

/** A ray from the middle of a face. */
class FaceRay
{
public:
    FaceRay(const VoxelGrid& grid, const glm::dvec3& direction, int side, double reach) :
        _path(grid, getMiddle(grid, side), direction, reach)
    {
        for (const OcclusionPath::Step& step : _path.getSteps())
        {
            const double hidden = fadeOcclusion(step.distance, reach);
            const double near = isKnown(step.voxel, side / 2)
                                    ? fadeOcclusion(step.distance, AmbientOcclusionSettings::RADIUS_IN_BRICKS)
                                    : 0.0;
            _hits.push_back({static_cast<float>(hidden), static_cast<float>(std::max(hidden - near, 0.0))});
        }
    }

    struct Hit
    {
        float hidden;  // the fraction that it hides
        float distant; // that which near occlusion does not know
    };

    const glm::vec3& getDirection() const { return _path.getDirection(); }

    /** The first hit; null if there is none. @param covered that of the first voxel. */
    const Hit* findHit(const std::uint8_t* covered) const
    {
        const std::optional<std::size_t> step = _path.findHit(covered);
        return step ? &_hits[*step] : nullptr;
    }

private:
    /** The middle of a face, from the corner of the voxel in front of it. */
    static glm::dvec3 getMiddle(const VoxelGrid& grid, int side)
    {
        glm::dvec3 middle = 0.5 * grid.getExtent();
        middle[side / 2] = side % 2 == 0 ? grid.getExtent()[side / 2] : 0.0;
        return middle;
    }

    OcclusionPath _path;
    std::vector<Hit> _hits; // by step
};

using FaceRays = std::array<std::vector<FaceRay>, NUM_SIDES>;

FaceRays createRays(const VoxelGrid& grid, double reach)
{
    const std::vector<glm::dvec3> hemisphere = createHemisphere(NUM_DIRECTIONS);
    FaceRays rays;
    for (int side = 0; side < NUM_SIDES; ++side)
        for (const glm::dvec3& direction : hemisphere)
        {
            glm::dvec3 turned;
            turned[side / 2] = side % 2 == 0 ? -direction.z : direction.z;
            turned[(side / 2 + 1) % 3] = direction.x;
            turned[(side / 2 + 2) % 3] = direction.y;
            rays[static_cast<std::size_t>(side)].emplace_back(grid, turned, side, reach);
        }
    return rays;
}

/** The voxels in front of open faces: bits of BrickSide, by place. */
std::vector<std::uint8_t> findFaces(const VoxelGrid& grid, std::span<const BrickPoint> points)
{
    std::vector<std::uint8_t> faces(grid.getNumVoxels(), 0);
    for (const BrickPoint& point : points)
    {
        const Brick brick = unpackBrick(point);
        for (int side = 0; side < NUM_SIDES; ++side)
            if (brick.openSides & 1 << side)
                faces[grid.getPlace(brick.getCell() + VoxelGrid::BORDER + getNormal(side))] |=
                    static_cast<std::uint8_t>(1 << side);
    }
    return faces;
}

class FaceOcclusion
{
public:
    FaceOcclusion(const VoxelGrid& grid, std::span<const BrickPoint> points, double reach) :
        _grid(grid), _faces(findFaces(grid, points)), _rays(createRays(grid, reach))
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
                    castRays(place, each, sums);
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

    void castRays(std::size_t place, int side, Sums& sums) const
    {
        // Bent normals move by this part of `bend`; see shaders/light/distant_light.glsl.
        constexpr float BEND = 0.5625f;
        // The mean open direction of an open hemisphere is two thirds as long as its normal.
        constexpr float MEAN_DIRECTION = 2.0f / 3.0f;
        const std::uint8_t* covered = _grid.getCovered() + place;
        float hidden = 0.0f;
        float distant = 0.0f;
        glm::vec3 towards(0.0f);
        for (const FaceRay& ray : _rays[static_cast<std::size_t>(side)])
        {
            const FaceRay::Hit* hit = ray.findHit(covered);
            if (!hit) continue;
            hidden += hit->hidden;
            distant += hit->distant;
            towards += hit->distant * ray.getDirection();
        }
        const int axis = side / 2;
        sums.mean[axis] += hidden / static_cast<float>(NUM_DIRECTIONS);
        sums.meanCount[axis] += 1.0f;
        for (int other = (axis + 1) % 3; other != axis; other = (other + 1) % 3)
        {
            sums.bend[other] += towards[other] / (BEND * MEAN_DIRECTION * static_cast<float>(NUM_DIRECTIONS));
            sums.bendCount[other] += 1.0f;
        }
        sums.distant += distant / static_cast<float>(NUM_DIRECTIONS);
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
