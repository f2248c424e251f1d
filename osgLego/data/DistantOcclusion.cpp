#include <osgLego/data/DistantOcclusion.h>

#include <osgLego/data/OcclusionFalloff.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace osgLego
{

namespace
{

constexpr int NUM_DIRECTIONS = 64;
constexpr int BORDER = DistantOcclusion::BORDER;

/** In pitches. */
double longestSide(const BrickGrid& grid)
{
    const glm::dvec3 sides = glm::dvec3(grid.dimensions) * grid.cellSize / grid.getPitch();
    return std::max({sides.x, sides.y, sides.z});
}

/** The voxels around a grid of cells, with a margin wide enough for every ray. */
class VoxelGrid
{
public:
    explicit VoxelGrid(const BrickGrid& grid)
    {
        const glm::dvec3 cell = grid.cellSize / grid.getPitch();
        const double longest = longestSide(grid);
        const double width = std::max(1.0, std::ceil(longest / DistantOcclusion::MAXIMUM_SIZE));
        cellsPerVoxel = glm::ivec3(glm::clamp(glm::round(width / cell), 1.0, double(LegoSettings::MAXIMUM_LAYERS)));
        extent = glm::dvec3(cellsPerVoxel) * cell;
        size = (grid.dimensions + cellsPerVoxel - 1) / cellsPerVoxel + 2 * BORDER;
        reach = DistantOcclusion::getReach(grid);
        margin = glm::ivec3(glm::ceil(reach / extent)) + 1;
        const glm::ivec3 all = size + 2 * margin;
        strides = {1, all.x, static_cast<std::ptrdiff_t>(all.x) * all.y};
        counts.assign(static_cast<std::size_t>(strides.z) * static_cast<std::size_t>(all.z), 0);
    }

    std::size_t placeOf(const glm::ivec3& voxel) const
    {
        const glm::ivec3 place = voxel + margin;
        return static_cast<std::size_t>(place.x * strides.x + place.y * strides.y + place.z * strides.z);
    }

    void add(std::span<const BrickPoint> points)
    {
        for (const BrickPoint& point : points)
            ++counts[placeOf(unpackBrick(point).getCell() / cellsPerVoxel + BORDER)];
        // A surface through the middle of a voxel has as many bricks as the largest side of the voxel has cells.
        const int side = std::max(
            {cellsPerVoxel.x * cellsPerVoxel.y, cellsPerVoxel.y * cellsPerVoxel.z, cellsPerVoxel.z * cellsPerVoxel.x});
        for (std::uint32_t& count : counts)
            count = 2 * count >= static_cast<std::uint32_t>(side) ? 1 : 0;
    }

    glm::ivec3 cellsPerVoxel{1};
    glm::dvec3 extent{1.0}; // of a voxel, in pitches
    glm::ivec3 size{0};     // in voxels, with the border
    double reach = 0.0;     // pitches
    glm::ivec3 margin{0};   // voxels
    glm::vec<3, std::ptrdiff_t> strides{0};
    std::vector<std::uint32_t> counts; // 1 for voxels with bricks
};

/** The voxels that a ray from the centre of a voxel passes, nearest first. It is the same for every voxel. */
struct Path
{
    struct Step
    {
        std::ptrdiff_t offset; // from the first voxel
        glm::vec3 weights;     // of a hit, for faces across each axis
    };

    glm::vec3 direction;
    std::vector<Step> steps;
};

/** Whether a voxel is known to the near occlusion of the grid, or may be.
 * @param voxel relative to the one in front of a face across an axis. */
bool isInFront(const VoxelGrid& grid, const glm::ivec3& voxel, int axis)
{
    constexpr int NUM_LAYERS = 3;
    const glm::ivec3 away = glm::abs(voxel);
    return grid.cellsPerVoxel != glm::ivec3(1) ||
           (away[axis] < NUM_LAYERS && away[(axis + 1) % 3] <= 1 && away[(axis + 2) % 3] <= 1);
}

Path createPath(const VoxelGrid& grid, const glm::dvec3& direction, NearOcclusion near)
{
    Path path{glm::vec3(direction), {}};
    // Steps of a surface of voxels must not occlude each other, so voxels of several cells need a larger radius.
    const double nearest = AmbientOcclusionSettings::RADIUS_IN_BRICKS * std::max(grid.extent.x, grid.extent.y);
    const glm::dvec3 steps = grid.extent / glm::max(glm::abs(direction), 1e-12);
    glm::dvec3 next = 0.5 * steps;
    glm::ivec3 voxel(0);
    while (true)
    {
        const int axis = next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2;
        const double distance = next[axis];
        if (distance >= grid.reach) return path;
        voxel[axis] += direction[axis] < 0.0 ? -1 : 1;
        next[axis] += steps[axis];
        const std::ptrdiff_t offset = voxel.x * grid.strides.x + voxel.y * grid.strides.y + voxel.z * grid.strides.z;
        glm::vec3 weights(static_cast<float>(fadeOcclusion(distance, grid.reach)));
        for (int side = 0; side < 3; ++side)
            if (near == NearOcclusion::PICTURE || isInFront(grid, voxel, side))
                weights[side] -= static_cast<float>(fadeOcclusion(distance, nearest));
        path.steps.push_back({offset, weights});
    }
}

/** Paths in directions that are evenly distributed over the sphere, by Fibonacci's lattice. */
std::vector<Path> createPaths(const VoxelGrid& grid, NearOcclusion near)
{
    std::vector<Path> paths;
    for (int index = 0; index < NUM_DIRECTIONS; ++index)
    {
        const double z = 1.0 - (2.0 * index + 1.0) / NUM_DIRECTIONS;
        const double angle = 2.0 * std::numbers::pi * std::numbers::phi * index;
        const double radius = std::sqrt(1.0 - z * z);
        paths.push_back(createPath(grid, {radius * std::cos(angle), radius * std::sin(angle), z}, near));
    }
    return paths;
}

/** The hidden fractions of surfaces that face the ends of the axes. */
struct Cube
{
    std::array<glm::vec3, 2> sides{glm::vec3(0.0f), glm::vec3(0.0f)}; // lower ends, upper ends

    void add(const glm::vec3& direction, const glm::vec3& weight)
    {
        sides[0] += weight * glm::max(-direction, 0.0f);
        sides[1] += weight * glm::max(direction, 0.0f);
    }
    void add(const Cube& cube)
    {
        for (std::size_t end = 0; end < sides.size(); ++end)
            sides[end] += cube.sides[end];
    }
    void divideBy(const Cube& cube)
    {
        for (std::size_t end = 0; end < sides.size(); ++end)
            sides[end] /= cube.sides[end];
    }
};

/** The cube of a voxel all of whose rays hit at full weight; other cubes are divided by it. */
Cube sumDirections(const std::vector<Path>& paths)
{
    Cube sum;
    for (const Path& path : paths)
        sum.add(path.direction, glm::vec3(1.0f));
    return sum;
}

/** @param all the result of sumDirections(). */
Cube castRays(const VoxelGrid& grid, const std::vector<Path>& paths, const Cube& all, std::size_t place)
{
    const std::uint32_t* voxel = grid.counts.data() + place;
    Cube hidden;
    for (const Path& path : paths)
    {
        const auto hit = std::find_if(path.steps.begin(), path.steps.end(),
                                      [&](const Path::Step& step) { return voxel[step.offset] != 0; });
        if (hit != path.steps.end()) hidden.add(path.direction, glm::max(hit->weights, 0.0f));
    }
    hidden.divideBy(all);
    return hidden;
}

/** Whether any of the 26 neighbours of a voxel has bricks. */
bool isNearBricks(const VoxelGrid& grid, std::size_t place)
{
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (grid.counts[place + static_cast<std::size_t>(x * grid.strides.x + y * grid.strides.y +
                                                                 z * grid.strides.z)] != 0)
                    return true;
    return false;
}

template <typename Function>
void forEachVoxel(const glm::ivec3& size, const Function& function)
{
    // Isolated: while it waits here, the thread must not run tasks of the caller, which may need locks that it holds.
    oneapi::tbb::this_task_arena::isolate(
        [&]
        {
            oneapi::tbb::parallel_for(0, size.z,
                                      [&](int z)
                                      {
                                          for (int y = 0; y < size.y; ++y)
                                              for (int x = 0; x < size.x; ++x)
                                                  function(glm::ivec3(x, y, z));
                                      });
        });
}

/** The cubes of voxels, for those that have one. */
class Cubes
{
public:
    explicit Cubes(const glm::ivec3& size) :
        _size(size), _cubes(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y * size.z))
    {
    }

    std::optional<Cube>& at(const glm::ivec3& voxel)
    {
        return _cubes[static_cast<std::size_t>(voxel.x + _size.x * (voxel.y + _size.y * voxel.z))];
    }

    /** The mean of the neighbours that have cubes; 0 if there are none. */
    Cube getMeanAround(const glm::ivec3& voxel)
    {
        Cube sum;
        Cube count;
        const glm::ivec3 first = glm::max(voxel - 1, 0);
        const glm::ivec3 last = glm::min(voxel + 1, _size - 1);
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x)
                {
                    const std::optional<Cube>& cube = at({x, y, z});
                    if (!cube) continue;
                    sum.add(*cube);
                    count.add({{glm::vec3(1.0f), glm::vec3(1.0f)}});
                }
        if (count.sides[0].x > 0.0f) sum.divideBy(count);
        return sum;
    }

private:
    glm::ivec3 _size;
    std::vector<std::optional<Cube>> _cubes;
};

void write(const glm::vec3& hidden, unsigned char* bytes)
{
    for (int channel = 0; channel < 3; ++channel)
        bytes[channel] = static_cast<unsigned char>(std::lround(255.0f * std::min(hidden[channel], 1.0f)));
    bytes[3] = 255;
}

} // namespace

double DistantOcclusion::getReach(const BrickGrid& grid)
{
    return 0.25 * longestSide(grid);
}

osg::ref_ptr<const DistantOcclusion> DistantOcclusion::create(const BrickGrid& grid, std::span<const BrickPoint> points,
                                                              NearOcclusion near)
{
    VoxelGrid voxels(grid);
    voxels.add(points);
    const std::vector<Path> paths = createPaths(voxels, near);
    const Cube all = sumDirections(paths);
    Cubes cubes(voxels.size);
    forEachVoxel(voxels.size,
                 [&](const glm::ivec3& voxel)
                 {
                     const std::size_t place = voxels.placeOf(voxel);
                     if (voxels.counts[place] == 0 && isNearBricks(voxels, place))
                         cubes.at(voxel) = castRays(voxels, paths, all, place);
                 });
    osg::ref_ptr<DistantOcclusion> result = new DistantOcclusion(voxels.cellsPerVoxel);
    for (osg::ref_ptr<osg::Image>& image : result->_images)
    {
        image = new osg::Image;
        image->allocateImage(voxels.size.x, voxels.size.y, voxels.size.z, GL_RGBA, GL_UNSIGNED_BYTE);
    }
    forEachVoxel(voxels.size,
                 [&](const glm::ivec3& voxel)
                 {
                     const Cube cube = cubes.at(voxel) ? *cubes.at(voxel) : cubes.getMeanAround(voxel);
                     for (std::size_t end = 0; end < cube.sides.size(); ++end)
                         write(cube.sides[end], result->_images[end]->data(static_cast<unsigned int>(voxel.x),
                                                                           static_cast<unsigned int>(voxel.y),
                                                                           static_cast<unsigned int>(voxel.z)));
                 });
    return result;
}

} // namespace osgLego
