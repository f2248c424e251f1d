#include <osgLego/data/DistantOcclusion.h>

#include <osgLego/data/CoarseFaceOcclusion.h>
#include <osgLego/data/FaceOcclusion.h>
#include <osgLego/data/ForEachVoxel.h>
#include <osgLego/data/OcclusionFalloff.h>
#include <osgLego/data/OcclusionPath.h>
#include <osgLego/data/VolumeMipmaps.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>

namespace osgLego
{

namespace
{

constexpr int NUM_DIRECTIONS = 64;

/** A path, and the weights of hits at its steps. */
struct WeighedPath
{
    OcclusionPath path;
    std::vector<float> weights;
};

/** Paths from the centre of a voxel. */
std::vector<WeighedPath> createPaths(const VoxelGrid& grid, double reach)
{
    // Steps of a surface of voxels must not occlude each other, so voxels of several cells need a larger radius.
    const double nearest =
        AmbientOcclusionSettings::RADIUS_IN_BRICKS * std::max(grid.getExtent().x, grid.getExtent().y);
    std::vector<WeighedPath> paths;
    for (const glm::dvec3& direction : createSphere(NUM_DIRECTIONS))
    {
        WeighedPath path{OcclusionPath(grid, 0.5 * grid.getExtent(), direction, reach), {}};
        for (const OcclusionPath::Step& step : path.path.getSteps())
            path.weights.push_back(static_cast<float>(
                std::max(fadeOcclusion(step.distance, reach) - fadeOcclusion(step.distance, nearest), 0.0)));
        paths.push_back(std::move(path));
    }
    return paths;
}

/** The hidden fractions of surfaces that face the ends of the axes. */
struct Cube
{
    glm::vec3 lower{0.0f};
    glm::vec3 upper{0.0f};

    void add(const glm::vec3& direction, float weight)
    {
        lower += weight * glm::max(-direction, 0.0f);
        upper += weight * glm::max(direction, 0.0f);
    }
};

/** The cube of a voxel all of whose rays hit at full weight; other cubes are divided by it. */
Cube sumDirections(const std::vector<WeighedPath>& paths)
{
    Cube sum;
    for (const WeighedPath& path : paths)
        sum.add(path.path.getDirection(), 1.0f);
    return sum;
}

/** @param all the result of sumDirections(). */
OcclusionVolume::Light castRays(const VoxelGrid& grid, const std::vector<WeighedPath>& paths, const Cube& all,
                                const glm::ivec3& voxel)
{
    const std::uint8_t* covered = grid.getCovered() + grid.getPlace(voxel);
    Cube hidden;
    for (const WeighedPath& path : paths)
    {
        const std::optional<std::size_t> hit = path.path.findHit(covered, 0, path.path.countStepsInside(voxel));
        if (hit) hidden.add(path.path.getDirection(), path.weights[*hit]);
    }
    const glm::vec3 lower = hidden.lower / all.lower;
    const glm::vec3 upper = hidden.upper / all.upper;
    return {0.5f * (lower + upper), 0.5f * (upper - lower), 0.0f};
}

/** Whether any of the 26 neighbours of a voxel has bricks. */
bool isNearBricks(const VoxelGrid& grid, std::size_t place)
{
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (grid.isCovered(place + static_cast<std::size_t>(grid.getOffset({x, y, z})))) return true;
    return false;
}

OcclusionVolume findDistantOcclusion(const VoxelGrid& grid, double reach)
{
    const std::vector<WeighedPath> paths = createPaths(grid, reach);
    const Cube all = sumDirections(paths);
    OcclusionVolume volume(grid.getSize());
    forEachVoxel(grid.getSize(),
                 [&](const glm::ivec3& voxel)
                 {
                     const std::size_t place = grid.getPlace(voxel);
                     if (!grid.isCovered(place) && isNearBricks(grid, place))
                         volume.set(voxel, castRays(grid, paths, all, voxel), OcclusionVolume::ALL);
                 });
    volume.fillFromNeighbors(OcclusionVolume::Neighbors::ALL, [](const glm::ivec3&) { return true; });
    return volume;
}

/** Whether voxels take no more memory than those of a cube of DistantOcclusion::MAXIMUM_CELLS, with margins for rays in
 * all directions. */
bool isSmall(const VoxelGrid& grid)
{
    constexpr std::size_t MAXIMUM_SIDE = 256; // of textures, which every implementation of OpenGL 3 has
    constexpr std::size_t MOST = DistantOcclusion::MAXIMUM_CELLS + 2 * DistantOcclusion::BORDER;
    constexpr std::size_t MOST_WITH_MARGINS = 2 * MOST;
    const glm::u64vec3 size(grid.getSize());
    return std::max({size.x, size.y, size.z}) <= MAXIMUM_SIDE && size.x * size.y * size.z <= MOST * MOST * MOST &&
           grid.getNumVoxels() <= MOST_WITH_MARGINS * MOST_WITH_MARGINS * MOST_WITH_MARGINS;
}

} // namespace

double DistantOcclusion::getReach(const BrickGrid& grid)
{
    return 0.25 * VoxelGrid::getLongestSide(grid);
}

DistantOcclusion::DistantOcclusion(const VoxelGrid& grid, const OcclusionVolume& volume, bool includesNear) :
    _cellsPerVoxel(grid.getCellsPerVoxel()), _images(volume.createImages()), _includesNear(includesNear)
{
    for (osg::ref_ptr<osg::Image>& image : _images)
        image = createVolumeMipmaps(*image);
}

osg::ref_ptr<const DistantOcclusion> DistantOcclusion::create(const BrickGrid& grid, std::span<const BrickPoint> points,
                                                              NearOcclusion near)
{
    const double reach = getReach(grid);
    if (near == NearOcclusion::GRID)
    {
        VoxelGrid cells(grid, 0.0, reach);
        if (isSmall(cells))
        {
            cells.cover(points);
            return new DistantOcclusion(cells, findFaceOcclusion(cells, points, reach), true);
        }
    }
    constexpr double MARGIN = 3.0; // voxels; rays through voxels begin where those through cells end
    const int most = near == NearOcclusion::GRID ? MAXIMUM_CELLS : MAXIMUM_SIZE;
    const double width = std::max(1.0, std::ceil(VoxelGrid::getLongestSide(grid) / most));
    VoxelGrid voxels(grid, width, near == NearOcclusion::GRID ? reach + MARGIN * width : reach);
    voxels.cover(points);
    return new DistantOcclusion(voxels,
                                near == NearOcclusion::GRID ? findCoarseFaceOcclusion(grid, voxels, points, reach)
                                                            : findDistantOcclusion(voxels, reach),
                                false);
}

} // namespace osgLego
