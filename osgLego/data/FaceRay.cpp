#include <osgLego/data/FaceRay.h>

#include <osgLego/data/OcclusionFalloff.h>

#include <algorithm>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

/** Whether the near occlusion of the grid knows a cell. @param cell relative to the one in front of a face. */
bool isKnown(const glm::ivec3& cell, int axis)
{
    constexpr int NUM_LAYERS = 3;
    const glm::ivec3 away = glm::abs(cell);
    return away[axis] < NUM_LAYERS && away[(axis + 1) % 3] <= 1 && away[(axis + 2) % 3] <= 1;
}

/** The middle of a face, from the corner of the cell in front of it. */
glm::dvec3 getMiddle(const VoxelGrid& cells, int side)
{
    glm::dvec3 middle = 0.5 * cells.getExtent();
    middle[side / 2] = side % 2 == 0 ? cells.getExtent()[side / 2] : 0.0;
    return middle;
}

} // namespace

FaceRay::FaceRay(const VoxelGrid& cells, const glm::dvec3& direction, int side, double reach, double length) :
    _path(cells, getMiddle(cells, side), direction, length)
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

FaceRays createFaceRays(const VoxelGrid& cells, double reach, double length)
{
    const std::vector<glm::dvec3> hemisphere = createHemisphere(NUM_FACE_RAYS);
    FaceRays rays;
    for (int side = 0; side < NUM_SIDES; ++side)
        for (const glm::dvec3& direction : hemisphere)
        {
            glm::dvec3 turned;
            turned[side / 2] = side % 2 == 0 ? -direction.z : direction.z;
            turned[(side / 2 + 1) % 3] = direction.x;
            turned[(side / 2 + 2) % 3] = direction.y;
            rays[static_cast<std::size_t>(side)].emplace_back(cells, turned, side, reach, length);
        }
    return rays;
}

} // namespace osgLego
