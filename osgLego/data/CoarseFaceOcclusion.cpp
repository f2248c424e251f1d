#include <osgLego/data/CoarseFaceOcclusion.h>

#include <osgLego/data/FaceRay.h>
#include <osgLego/data/ForEachVoxel.h>
#include <osgLego/data/OcclusionFalloff.h>
#include <osgLego/data/SparseBox.h>

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

/** The cells of a grid that have bricks, or open faces beside them, with a margin. */
class SurfaceCells
{
public:
    /** @param margin in cells. */
    SurfaceCells(const glm::ivec3& dimensions, const glm::ivec3& margin, std::span<const BrickPoint> points) :
        _margin(margin), _cells(dimensions + 2 * margin)
    {
        for (const BrickPoint& point : points)
            _cells.edit(unpackBrick(point).getCell() + _margin) |= COVERED;
        forEachOpenFace(points, [this](const glm::ivec3& cell, int side)
                        { _cells.edit(cell + _margin) |= static_cast<std::uint8_t>(1 << side); });
    }

    bool isCovered(const glm::ivec3& cell) const { return (_cells.get(cell + _margin) & COVERED) != 0; }
    /** Whether a cell is in front of an open face. @param sides the bits of those that count, of bricks. */
    bool isBesideFace(const glm::ivec3& cell, int sides) const { return (_cells.get(cell + _margin) & sides) != 0; }

private:
    static constexpr std::uint8_t COVERED = 1 << NUM_SIDES;

    glm::ivec3 _margin;
    SparseBox<std::uint8_t> _cells; // bits of BrickSide, and COVERED
};

/** The continuation of a FaceRay through voxels. */
class CoarseRay
{
public:
    CoarseRay(const VoxelGrid& voxels, const FaceRay& ray, double reach) :
        _path(voxels, 0.5 * voxels.getExtent(), ray.getDirection(), reach)
    {
        std::size_t first = 0;
        glm::ivec3 start(0);
        for (const OcclusionPath::Step& near : ray.getSteps())
        {
            for (; first < _path.getSteps().size() && _path.getSteps()[first].distance < near.distance; ++first)
                start = _path.getSteps()[first].voxel;
            _beginnings.push_back({first, start});
        }
        for (const OcclusionPath::Step& step : _path.getSteps())
            _hidden.push_back(static_cast<float>(fadeOcclusion(step.distance, reach)));
    }

    /** The hidden fraction of the ray. @param step of the FaceRay, which it continues.
     * @param voxel of that step. If it has bricks, the ray passes along them, and hits those after the next voxel
     * without bricks. */
    float findHidden(const VoxelGrid& voxels, std::size_t step, const glm::ivec3& voxel) const
    {
        const Beginning& beginning = _beginnings[step];
        const glm::ivec3 start = voxel - beginning.passed;
        const std::uint8_t* covered = voxels.getCovered() + voxels.getPlace(start);
        const bool isCovered = voxels.isCovered(voxels.getPlace(voxel));
        const std::size_t gap = isCovered ? _path.findGap(covered, beginning.first) : beginning.first;
        // The path may begin outside of the grid.
        const std::size_t end = voxels.contains(start) ? _path.countStepsInside(start) : _path.getSteps().size();
        const std::optional<std::size_t> hit = _path.findHit(covered, gap, end);
        return hit ? _hidden[*hit] : 0.0f;
    }

private:
    struct Beginning
    {
        std::size_t first; // step that counts
        glm::ivec3 passed; // from the first voxel to the one before this step
    };

    OcclusionPath _path;
    std::vector<Beginning> _beginnings; // by step of the FaceRay
    std::vector<float> _hidden;         // by step
};

class CoarseFaceOcclusion
{
public:
    CoarseFaceOcclusion(const BrickGrid& grid, const VoxelGrid& voxels, std::span<const BrickPoint> points,
                        double reach) :
        _voxels(voxels),
        _nearest(NEAREST * std::max({voxels.getExtent().x, voxels.getExtent().y, voxels.getExtent().z})),
        _cells(grid.dimensions, glm::ivec3(glm::ceil(2.0 * _nearest * grid.getPitch() / grid.cellSize)) + 2, points),
        _sides(voxels.getNumVoxels(), 0),
        _rays(createFaceRays(VoxelGrid(grid, 0.0, 2.0 * _nearest), reach, std::min(2.0 * _nearest, reach)))
    {
        for (std::size_t side = 0; side < NUM_SIDES; ++side)
            for (const FaceRay& ray : _rays[side])
                _farRays[side].emplace_back(voxels, ray, reach);
        forEachOpenFace(points, [this](const glm::ivec3& cell, int side)
                        { _sides[_voxels.getPlace(getVoxel(cell))] |= static_cast<std::uint8_t>(1 << side); });
    }

    bool hasFaces(const glm::ivec3& voxel) const { return _sides[_voxels.getPlace(voxel)] != 0; }

    /** Find the light that is hidden from the faces in a voxel, which has some. */
    OcclusionVolume::Light find(const glm::ivec3& voxel) const
    {
        const int sides = _sides[_voxels.getPlace(voxel)];
        OcclusionVolume::Light light;
        for (int axis = 0; axis < 3; ++axis)
        {
            // Faces of a side count alone, and for both sides if there are no others along the axis. Along an axis
            // without faces, those of all sides tell from where light is hidden.
            const auto lower = static_cast<std::size_t>(2 * axis);
            const int faces = sides >> lower & 3;
            const float below = faces == 2 ? findHidden(voxel, lower + 1, 2 << lower)
                                           : findHidden(voxel, lower, faces == 0 ? sides : 1 << lower);
            const float above =
                faces == 1 || faces == 2 ? below : findHidden(voxel, lower + 1, faces == 0 ? sides : 2 << lower);
            light.mean[axis] = 0.5f * (below + above);
            light.bend[axis] = 0.5f * (above - below);
        }
        return light;
    }

private:
    /** The distance, in voxels, up to which rays meet bricks: nearer voxels are too coarse for the surface beside a
     * face. */
    static constexpr double NEAREST = AmbientOcclusionSettings::RADIUS_IN_BRICKS;

    glm::ivec3 getVoxel(const glm::ivec3& cell) const
    {
        return glm::ivec3(glm::floor(glm::vec3(cell) / glm::vec3(_voxels.getCellsPerVoxel()))) + VoxelGrid::BORDER;
    }

    /** The cells of a voxel in front of faces. @param sides the bits of those of the faces. */
    std::vector<glm::ivec3> findCells(const glm::ivec3& voxel, int sides) const
    {
        const glm::ivec3& size = _voxels.getCellsPerVoxel();
        const glm::ivec3 first = (voxel - VoxelGrid::BORDER) * size;
        std::vector<glm::ivec3> cells;
        for (int z = first.z; z < first.z + size.z; ++z)
            for (int y = first.y; y < first.y + size.y; ++y)
                for (int x = first.x; x < first.x + size.x; ++x)
                    if (_cells.isBesideFace({x, y, z}, sides)) cells.emplace_back(x, y, z);
        return cells;
    }

    /** The light that a ray finds hidden. It goes through cells up to `_nearest`, then on to a voxel without bricks,
     * since it passes beside those of other voxels.
     * @param cell in front of the face. */
    FaceRay::Hit castRay(const glm::ivec3& cell, const FaceRay& near, const CoarseRay& far) const
    {
        const std::vector<OcclusionPath::Step>& steps = near.getSteps();
        for (std::size_t step = 0; step < steps.size(); ++step)
        {
            const glm::ivec3 place = cell + steps[step].voxel;
            if (_cells.isCovered(place)) return near.getHit(step);
            if (step + 1 < steps.size() && steps[step].distance < _nearest) continue;
            const glm::ivec3 voxel = getVoxel(place);
            if (step + 1 < steps.size() && _voxels.isCovered(_voxels.getPlace(voxel))) continue;
            const float hidden = far.findHidden(_voxels, step, voxel);
            return {hidden, hidden};
        }
        return {0.0f, 0.0f};
    }

    /** The fraction of the light left by near occlusion that is hidden from surfaces that face a side. Each ray starts
     * in another cell in front of faces. @param faces the bits of their sides. */
    float findHidden(const glm::ivec3& voxel, std::size_t side, int faces) const
    {
        const std::vector<glm::ivec3> cells = findCells(voxel, faces);
        float hidden = 0.0f;
        float left = 0.0f;
        for (std::size_t ray = 0; ray < NUM_FACE_RAYS; ++ray)
        {
            const FaceRay::Hit hit = castRay(cells[ray % cells.size()], _rays[side][ray], _farRays[side][ray]);
            hidden += hit.distant;
            left += 1.0f - (hit.hidden - hit.distant);
        }
        return left > 0.0f ? hidden / left : 0.0f;
    }

    const VoxelGrid& _voxels;
    double _nearest; // in pitches
    SurfaceCells _cells;
    std::vector<std::uint8_t> _sides; // of faces in a voxel, by its place: bits of BrickSide
    FaceRays _rays;
    std::array<std::vector<CoarseRay>, NUM_SIDES> _farRays;
};

} // namespace

OcclusionVolume findCoarseFaceOcclusion(const BrickGrid& grid, const VoxelGrid& voxels,
                                        std::span<const BrickPoint> points, double reach)
{
    const CoarseFaceOcclusion faces(grid, voxels, points, reach);
    OcclusionVolume volume(voxels.getSize());
    forEachVoxel(voxels.getSize(),
                 [&](const glm::ivec3& voxel)
                 {
                     if (faces.hasFaces(voxel)) volume.set(voxel, faces.find(voxel), OcclusionVolume::ALL);
                 });
    volume.fillFromNeighbors(OcclusionVolume::Neighbors::ALL, [](const glm::ivec3&) { return true; });
    volume.fillFromBlocks();
    return volume;
}

} // namespace osgLego
