#include <osgLego/data/DistantOcclusion.h>

#include <osgLego/AmbientOcclusionSettings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace osgLego
{

namespace
{

constexpr int NUM_DIRECTIONS = 64;
constexpr int BORDER = DistantOcclusion::BORDER;

/** The voxels around a grid of cells, with a margin wide enough for every ray. */
class VoxelGrid
{
public:
    explicit VoxelGrid(const BrickGrid& grid)
    {
        const glm::dvec3 cell = grid.cellSize / grid.getPitch();
        const glm::dvec3 sides = glm::dvec3(grid.dimensions) * cell;
        const double longest = std::max({sides.x, sides.y, sides.z});
        const double width = std::max(1.0, std::ceil(longest / DistantOcclusion::MAXIMUM_SIZE));
        cellsPerVoxel = glm::max(glm::ivec3(glm::round(width / cell)), 1);
        extent = glm::dvec3(cellsPerVoxel) * cell;
        size = (grid.dimensions + cellsPerVoxel - 1) / cellsPerVoxel + 2 * BORDER;
        reach = DistantOcclusion::REACH * longest;
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
        {
            const glm::ivec3 cell(point[0] & 0xffff, point[0] >> 16, point[1] & 0xffff);
            ++counts[placeOf(cell / cellsPerVoxel + BORDER)];
        }
        // A surface through the middle of a voxel has as many bricks as its largest side has cells.
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
        float weight;          // of a hit
    };

    glm::vec3 direction;
    std::vector<Step> steps;
};

double fade(double distance, double radius)
{
    return std::clamp((radius - distance) / (radius * AmbientOcclusionSettings::FALLOFF), 0.0, 1.0);
}

Path createPath(const VoxelGrid& grid, const glm::dvec3& direction)
{
    Path path{glm::vec3(direction), {}};
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
        path.steps.push_back({offset, static_cast<float>(fade(distance, grid.reach) -
                                                         fade(distance, AmbientOcclusionSettings::RADIUS_IN_BRICKS))});
    }
}

/** Paths in directions that are evenly distributed over the sphere, by Fibonacci's lattice. */
std::vector<Path> createPaths(const VoxelGrid& grid)
{
    std::vector<Path> paths;
    for (int index = 0; index < NUM_DIRECTIONS; ++index)
    {
        const double z = 1.0 - (2.0 * index + 1.0) / NUM_DIRECTIONS;
        const double angle = 2.0 * std::numbers::pi * std::numbers::phi * index;
        const double radius = std::sqrt(1.0 - z * z);
        paths.push_back(createPath(grid, {radius * std::cos(angle), radius * std::sin(angle), z}));
    }
    return paths;
}

/** b and a of a voxel, as class DistantOcclusion describes them. */
glm::vec4 castRays(const VoxelGrid& grid, const std::vector<Path>& paths, std::size_t place)
{
    const std::uint32_t* voxel = grid.counts.data() + place;
    glm::vec4 sum(0.0f);
    for (const Path& path : paths)
        for (const Path::Step& step : path.steps)
        {
            if (voxel[step.offset] == 0) continue;
            sum += std::max(step.weight, 0.0f) * glm::vec4(2.0f * path.direction, 1.0f);
            break;
        }
    return sum / static_cast<float>(paths.size());
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

/** The values of voxels. Voxels without a value have a negative a. */
class Values
{
public:
    explicit Values(const glm::ivec3& size) :
        _size(size), _values(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y * size.z))
    {
    }

    glm::vec4& at(const glm::ivec3& voxel)
    {
        return _values[static_cast<std::size_t>(voxel.x + _size.x * (voxel.y + _size.y * voxel.z))];
    }
    const glm::vec4& at(const glm::ivec3& voxel) const { return const_cast<Values*>(this)->at(voxel); }

    /** The mean of the neighbours that have values; 0 if there are none. */
    glm::vec4 getMeanAround(const glm::ivec3& voxel) const
    {
        glm::vec4 sum(0.0f);
        float count = 0.0f;
        const glm::ivec3 first = glm::max(voxel - 1, 0);
        const glm::ivec3 last = glm::min(voxel + 1, _size - 1);
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x)
                {
                    const glm::vec4& value = at({x, y, z});
                    if (value.w < 0.0f) continue;
                    sum += value;
                    count += 1.0f;
                }
        return count > 0.0f ? sum / count : sum;
    }

private:
    glm::ivec3 _size;
    std::vector<glm::vec4> _values;
};

void write(const glm::vec4& value, unsigned char* bytes)
{
    const glm::vec4 scaled = glm::clamp(glm::vec4(127.0f + 127.0f * glm::vec3(value), 255.0f * value.w), 0.0f, 255.0f);
    for (int channel = 0; channel < 4; ++channel)
        bytes[channel] = static_cast<unsigned char>(std::lround(scaled[channel]));
}

} // namespace

osg::ref_ptr<const DistantOcclusion> DistantOcclusion::create(const BrickGrid& grid, std::span<const BrickPoint> points)
{
    VoxelGrid voxels(grid);
    voxels.add(points);
    const std::vector<Path> paths = createPaths(voxels);
    const glm::vec4 nothing(0.0f, 0.0f, 0.0f, -1.0f);
    Values values(voxels.size);
    forEachVoxel(voxels.size,
                 [&](const glm::ivec3& voxel)
                 {
                     const std::size_t place = voxels.placeOf(voxel);
                     const bool isUsed = voxels.counts[place] == 0 && isNearBricks(voxels, place);
                     values.at(voxel) = isUsed ? castRays(voxels, paths, place) : nothing;
                 });
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(voxels.size.x, voxels.size.y, voxels.size.z, GL_RGBA, GL_UNSIGNED_BYTE);
    forEachVoxel(voxels.size,
                 [&](const glm::ivec3& voxel)
                 {
                     const glm::vec4& own = values.at(voxel);
                     write(own.w < 0.0f ? values.getMeanAround(voxel) : own,
                           image->data(static_cast<unsigned int>(voxel.x), static_cast<unsigned int>(voxel.y),
                                       static_cast<unsigned int>(voxel.z)));
                 });
    return new DistantOcclusion(voxels.cellsPerVoxel, *image);
}

} // namespace osgLego
