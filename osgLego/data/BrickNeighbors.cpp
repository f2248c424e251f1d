#include <osgLego/data/BrickNeighbors.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace osgLego
{

namespace
{

constexpr int REACH = 3; // the greatest distance of a neighbour, in cells

/** The cells of a block, of which the bits of a byte are those along x. */
using Block = std::array<std::array<std::uint8_t, BrickPoints::BLOCK_SIDE>, BrickPoints::BLOCK_SIDE>;

/** Consecutive points in one block. */
struct Run
{
    glm::ivec3 block;
    std::size_t begin;
    std::size_t end;
};

glm::ivec3 getCell(const BrickPoint& point)
{
    return {point[0] & 0xffffu, point[0] >> 16, point[1] & 0xffffu};
}

std::vector<Run> findRuns(std::span<const BrickPoint> points)
{
    std::vector<Run> runs;
    for (std::size_t index = 0; index < points.size(); ++index)
    {
        const glm::ivec3 block = getCell(points[index]) / BrickPoints::BLOCK_SIDE;
        if (runs.empty() || runs.back().block != block) runs.push_back({block, index, index});
        runs.back().end = index + 1;
    }
    return runs;
}

/** The covered cells, in blocks. */
class CoveredCells
{
public:
    CoveredCells(std::span<const BrickPoint> points, const std::vector<Run>& runs)
    {
        _blocks.reserve(runs.size());
        for (const Run& run : runs)
        {
            Block& block = _blocks[keyOf(run.block)];
            for (const BrickPoint& point : points.subspan(run.begin, run.end - run.begin))
            {
                const glm::ivec3 place = getCell(point) % BrickPoints::BLOCK_SIDE;
                block[static_cast<std::size_t>(place.z)][static_cast<std::size_t>(place.y)] |=
                    static_cast<std::uint8_t>(1u << place.x);
            }
        }
    }

    /** The cells of a block; null if none is covered. */
    const Block* find(const glm::ivec3& block) const
    {
        const auto found = _blocks.find(keyOf(block));
        return found == _blocks.end() ? nullptr : &found->second;
    }

private:
    static std::uint64_t keyOf(const glm::ivec3& block)
    {
        constexpr int BITS = 16;
        const auto key = [](int place) { return static_cast<std::uint64_t>(place + 1); };
        return key(block.x) | key(block.y) << BITS | key(block.z) << 2 * BITS;
    }

    std::unordered_map<std::uint64_t, Block> _blocks;
};

constexpr std::size_t WINDOW_WIDTH = 2 * REACH + 1;
constexpr std::uint32_t WINDOW_BITS = (1u << WINDOW_WIDTH) - 1u;
using Window = std::array<std::array<std::uint8_t, WINDOW_WIDTH>, WINDOW_WIDTH>;

/** The cells of a block and around it. */
class Surroundings
{
public:
    Surroundings(const CoveredCells& cells, const glm::ivec3& block)
    {
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    if (const Block* found = cells.find(block + glm::ivec3(x, y, z))) add(*found, {x, y, z});
    }

    /** The cells around a cell, at a distance of up to REACH along each axis: bits along x, for each z and y.
     * @param cell from the lower corner of the block. */
    Window getWindow(const glm::ivec3& cell) const
    {
        Window window;
        for (std::size_t z = 0; z < window.size(); ++z)
            for (std::size_t y = 0; y < window.size(); ++y)
                window[z][y] = static_cast<std::uint8_t>(
                    _rows[placeOf(cell.y - REACH, cell.z - REACH) + y + WIDTH * z] >> cell.x & WINDOW_BITS);
        return window;
    }

private:
    static constexpr int WIDTH = BrickPoints::BLOCK_SIDE + 2 * REACH;

    static std::size_t placeOf(int y, int z) { return static_cast<std::size_t>(y + REACH + WIDTH * (z + REACH)); }

    void add(const Block& block, const glm::ivec3& offset)
    {
        const glm::ivec3 first = BrickPoints::BLOCK_SIDE * offset;
        const glm::ivec3 begin = glm::max(first, -REACH) - first;
        const glm::ivec3 end = glm::min(first + BrickPoints::BLOCK_SIDE, BrickPoints::BLOCK_SIDE + REACH) - first;
        for (int z = begin.z; z < end.z; ++z)
            for (int y = begin.y; y < end.y; ++y)
            {
                const std::uint32_t row = block[static_cast<std::size_t>(z)][static_cast<std::size_t>(y)];
                const int shift = first.x + REACH;
                _rows[placeOf(first.y + y, first.z + z)] |=
                    (shift < 0 ? row >> -shift : row << shift) & ((1u << WIDTH) - 1u);
            }
    }

    std::array<std::uint32_t, std::size_t{WIDTH} * WIDTH> _rows{};
};

/** Collects the bits of a brick's neighbours. */
class NeighborBits
{
public:
    explicit NeighborBits(const Window& window) : _window(window) {}

    BrickNeighbors find(unsigned int openSides)
    {
        addEdges();
        addCorners();
        const int numLayers = std::popcount(openSides) < 5 ? 2 : 1;
        for (int side = 0; side < 6; ++side)
            for (int layer = 0; layer < numLayers && (openSides >> side & 1u); ++layer)
                addLayer(side / 2, side % 2 == 1 ? 2 + layer : -2 - layer);
        return _bits;
    }

private:
    /** Bits of cells along x, from a distance on. */
    std::uint32_t rowAt(int x, int y, int z) const
    {
        return static_cast<std::uint32_t>(
            _window[static_cast<std::size_t>(z + REACH)][static_cast<std::size_t>(y + REACH)] >> (x + REACH));
    }

    void add(std::uint64_t bits, unsigned int count)
    {
        bits <<= _next % 32;
        _bits[_next / 32] |= static_cast<std::uint32_t>(bits);
        if (bits >> 32 != 0) _bits[_next / 32 + 1] |= static_cast<std::uint32_t>(bits >> 32);
        _next += count;
    }

    void addEdges()
    {
        std::uint32_t bits = 0;
        for (int edge = 0; edge < 4; ++edge)
        {
            const int first = (edge & 1) != 0 ? 1 : -1;
            const int second = (edge & 2) != 0 ? 1 : -1;
            bits |= (rowAt(0, first, second) & 1u) << edge | (rowAt(second, 0, first) & 1u) << (4 + edge) |
                    (rowAt(first, second, 0) & 1u) << (8 + edge);
        }
        add(bits, 12);
    }

    void addCorners()
    {
        std::uint32_t bits = 0;
        for (int row = 0; row < 4; ++row)
        {
            const std::uint32_t cells = rowAt(-1, (row & 1) != 0 ? 1 : -1, (row & 2) != 0 ? 1 : -1);
            bits |= ((cells & 1u) | (cells >> 1 & 2u)) << 2 * row;
        }
        add(bits, 8);
    }

    /** The nine cells at a distance from the brick, with axes in the order of BrickNeighbors. */
    void addLayer(int axis, int distance)
    {
        std::uint32_t bits = 0;
        for (int v = -1; v <= 1; ++v)
        {
            if (axis == 2) bits |= (rowAt(-1, v, distance) & 7u) << 3 * (v + 1);
            for (int u = -1; u <= 1 && axis != 2; ++u)
                bits |= (axis == 0 ? rowAt(distance, u, v) & 1u : rowAt(v, distance, u) & 1u) << (u + 1 + 3 * (v + 1));
        }
        add(bits, 9);
    }

    const Window& _window;
    BrickNeighbors _bits{};
    std::size_t _next = 0;
};

} // namespace

std::vector<BrickNeighbors> createBrickNeighbors(std::span<const BrickPoint> points)
{
    const std::vector<Run> runs = findRuns(points);
    const CoveredCells cells(points, runs);
    std::vector<BrickNeighbors> result(points.size());
    const auto findNeighbors = [&](std::size_t number)
    {
        const Run& run = runs[number];
        const Surroundings surroundings(cells, run.block);
        for (std::size_t index = run.begin; index < run.end; ++index)
        {
            const Window window = surroundings.getWindow(getCell(points[index]) - BrickPoints::BLOCK_SIDE * run.block);
            result[index] = NeighborBits(window).find(points[index][1] >> 16 & 63u);
        }
    };
    // Isolated: while it waits here, the thread must not run tasks of the caller, which may need locks that it holds.
    oneapi::tbb::this_task_arena::isolate([&]
                                          { oneapi::tbb::parallel_for(std::size_t(0), runs.size(), findNeighbors); });
    return result;
}

} // namespace osgLego
