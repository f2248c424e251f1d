#include <osgLego/cpu/TriangleBins.h>

#include <osgLego/cpu/RowBundle.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <oneapi/tbb/parallel_for.h>

namespace osgLego
{

namespace
{

// The number of triangles that a thread sorts at a time.
constexpr std::size_t CHUNK = 16384;
// In cells. Compensates for rounding: a superfluous bundle costs little, but a missing one loses bricks.
constexpr float BIN_SLACK = 1e-2f;
constexpr std::uint32_t NO_BUNDLE = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t SEVERAL_BUNDLES = NO_BUNDLE - 1;

/** An interval on an axis. */
struct Range
{
    float lowest = std::numeric_limits<float>::max();
    float highest = std::numeric_limits<float>::lowest();

    void include(float place)
    {
        lowest = std::min(lowest, place);
        highest = std::max(highest, place);
    }
};

int bundleOf(float place, int last)
{
    return std::clamp(static_cast<int>(place) / RowBundle::SIDE, 0, last);
}

/** The positions of a triangle's corners in the cells of the grid. */
using Corners = std::array<glm::vec3, 3>;

/** The range of y that a triangle covers between two values of z. */
Range reachBetween(const Corners& corners, float from, float to)
{
    Range reach;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
        const glm::vec3& a = corners[corner];
        const glm::vec3& b = corners[(corner + 1) % 3];
        if (a.z >= from && a.z <= to) reach.include(a.y);
        for (const float layer : {from, to})
            if ((a.z < layer) != (b.z < layer)) reach.include(a.y + (layer - a.z) / (b.z - a.z) * (b.y - a.y));
    }
    return reach;
}

/** Call `use` with the number of every bundle that a triangle may reach into. */
template <typename Use>
void forEachBundle(const Corners& corners, const glm::ivec2& size, const Use& use)
{
    Range y;
    Range z;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
        y.include(corners[corner].y);
        z.include(corners[corner].z);
    }
    const glm::ivec2 last = size - 1;
    const int firstZ = bundleOf(z.lowest - BIN_SLACK, last.y);
    const int lastZ = bundleOf(z.highest + BIN_SLACK, last.y);
    const bool isSmall = firstZ == lastZ || bundleOf(y.lowest, last.x) == bundleOf(y.highest, last.x);
    for (int bundle = firstZ; bundle <= lastZ; ++bundle)
    {
        // A long triangle reaches into only a few of the bundles in its bounds.
        const auto layer = static_cast<float>(bundle * RowBundle::SIDE);
        const Range reach = isSmall ? y : reachBetween(corners, layer - BIN_SLACK, layer + RowBundle::SIDE + BIN_SLACK);
        if (reach.lowest > reach.highest) continue;
        const int lastY = bundleOf(reach.highest + BIN_SLACK, last.x);
        for (int row = bundleOf(reach.lowest - BIN_SLACK, last.x); row <= lastY; ++row)
            use(static_cast<std::size_t>(row) + static_cast<std::size_t>(size.x) * static_cast<std::size_t>(bundle));
    }
}

/** Consecutive triangles of one batch. */
struct Chunk
{
    const GridVertex* vertices;
    std::size_t count;
    std::uint32_t number; // of the first
    glm::vec3 corner;     // of the grid

    Corners getCorners(std::size_t triangle) const
    {
        const GridVertex* first = &vertices[3 * triangle];
        return {first[0].position - corner, first[1].position - corner, first[2].position - corner};
    }
};

std::vector<Chunk> cutIntoChunks(const GridTriangles& triangles)
{
    std::vector<Chunk> chunks;
    std::uint32_t number = 0;
    for (const GridBatch& batch : triangles.getBatches())
        for (std::size_t first = 0; first < batch.getNumTriangles(); first += CHUNK)
        {
            const std::size_t count = std::min(CHUNK, batch.getNumTriangles() - first);
            chunks.push_back({&batch.vertices[3 * first], count, number, glm::vec3(triangles.getFirstCell())});
            number += static_cast<std::uint32_t>(count);
        }
    return chunks;
}

} // namespace

TriangleBins::TriangleBins(const GridTriangles& triangles)
{
    const glm::ivec3& dimensions = triangles.getGrid().dimensions;
    _size = (glm::ivec2(dimensions.y, dimensions.z) + RowBundle::SIDE - 1) / RowBundle::SIDE;
    const std::vector<Chunk> chunks = cutIntoChunks(triangles);
    const std::size_t numBundles = getNumBundles();

    // A counting sort, which keeps the order of the triangles: count the triangles of each chunk in each bundle, turn
    // the counts into positions, then place the triangles.
    std::vector<std::vector<std::size_t>> places(chunks.size(), std::vector<std::size_t>(numBundles));
    // Most triangles reach into one bundle only, which need not be determined twice.
    std::vector<std::uint32_t> onlyBundles(triangles.getNumTriangles());
    const auto countChunk = [&](std::size_t chunk)
    {
        for (std::size_t triangle = 0; triangle < chunks[chunk].count; ++triangle)
        {
            std::uint32_t& only = onlyBundles[chunks[chunk].number + triangle];
            only = NO_BUNDLE;
            forEachBundle(chunks[chunk].getCorners(triangle), _size,
                          [&](std::size_t bundle)
                          {
                              only = only == NO_BUNDLE ? static_cast<std::uint32_t>(bundle) : SEVERAL_BUNDLES;
                              ++places[chunk][bundle];
                          });
        }
    };
    oneapi::tbb::parallel_for(std::size_t(0), chunks.size(), countChunk);

    std::size_t sum = 0;
    _begins.reserve(numBundles + 1);
    for (std::size_t bundle = 0; bundle < numBundles; ++bundle)
    {
        _begins.push_back(sum);
        for (std::vector<std::size_t>& counts : places)
            sum += std::exchange(counts[bundle], sum);
    }
    _begins.push_back(sum);

    _triangles.resize(sum);
    const auto placeChunk = [&](std::size_t chunk)
    {
        for (std::size_t triangle = 0; triangle < chunks[chunk].count; ++triangle)
        {
            const auto number = chunks[chunk].number + static_cast<std::uint32_t>(triangle);
            const std::uint32_t only = onlyBundles[number];
            const auto place = [&](std::size_t bundle) { _triangles[places[chunk][bundle]++] = number; };
            if (only == SEVERAL_BUNDLES)
                forEachBundle(chunks[chunk].getCorners(triangle), _size, place);
            else if (only != NO_BUNDLE)
                place(only);
        }
    };
    oneapi::tbb::parallel_for(std::size_t(0), chunks.size(), placeChunk);
}

} // namespace osgLego
