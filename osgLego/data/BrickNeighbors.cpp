#include <osgLego/data/BrickNeighbors.h>

#include <osgLego/data/CellKeys.h>

#include <bit>
#include <cstddef>
#include <functional>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
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

constexpr unsigned int BLOCK_CELLS = BrickPoints::BLOCK_SIDE;

glm::uvec3 getCell(const BrickPoint& point)
{
    return {point[0] & 0xffffu, point[0] >> 16, point[1] & 0xffffu};
}

std::vector<Run> findRuns(std::span<const BrickPoint> points)
{
    std::vector<Run> runs;
    for (std::size_t index = 0; index < points.size(); ++index)
    {
        const glm::ivec3 block(getCell(points[index]) / BLOCK_CELLS);
        if (runs.empty() || runs.back().block != block) runs.push_back({block, index, index});
        runs.back().end = index + 1;
    }
    return runs;
}

/** The covered cells, in blocks. */
class CoveredCells
{
public:
    CoveredCells(std::span<const BrickPoint> points, const std::vector<Run>& runs) :
        _slots(std::bit_ceil(2 * runs.size() + 1))
    {
        _blocks.reserve(runs.size());
        for (const Run& run : runs)
        {
            const CellKey key = keyOf(run.block);
            Slot& slot = _slots[findSlot(key)];
            if (slot.key == EMPTY)
            {
                slot = {key, _blocks.size()};
                _blocks.emplace_back();
            }
            Block& block = _blocks[slot.block];
            for (const BrickPoint& point : points.subspan(run.begin, run.end - run.begin))
            {
                const glm::uvec3 place = getCell(point) % BLOCK_CELLS;
                block[place.z][place.y] |= static_cast<std::uint8_t>(1u << place.x);
            }
        }
    }

    /** The cells of a block; null if none is covered. */
    const Block* find(const glm::ivec3& block) const
    {
        const Slot& slot = _slots[findSlot(keyOf(block))];
        return slot.key == EMPTY ? nullptr : &_blocks[slot.block];
    }

private:
    static constexpr CellKey EMPTY = 0;

    struct Slot
    {
        CellKey key = EMPTY;
        std::size_t block = 0;
    };

    /** Blocks begin at -1, beside the grid; no key is EMPTY. */
    static CellKey keyOf(const glm::ivec3& block) { return toCellKey(block + 2); }

    /** The slot of a key, or the one that is free for it: the first such slot after its hash. */
    std::size_t findSlot(CellKey key) const
    {
        const std::size_t mask = _slots.size() - 1;
        std::size_t slot = (key * 0x9e3779b97f4a7c15ull >> 32) & mask;
        while (_slots[slot].key != EMPTY && _slots[slot].key != key)
            slot = (slot + 1) & mask;
        return slot;
    }

    // A hash table with open addressing, at least half of whose slots are free, since each block looks 27 keys up.
    std::vector<Slot> _slots;
    std::vector<Block> _blocks;
};

/** The cells of a block and around it. */
class Surroundings
{
public:
    Surroundings(const CoveredCells& cells, const glm::ivec3& block)
    {
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y)
                add({find(cells, block + glm::ivec3(-1, y, z)), find(cells, block + glm::ivec3(0, y, z)),
                     find(cells, block + glm::ivec3(1, y, z))},
                    y, z);
    }

    /** Cells along x: those from -REACH to REACH are the lowest bits.
     * @param cell the middle of the row, from the lower corner of the block. */
    std::uint32_t getRow(const glm::ivec3& cell) const { return _rows[placeOf(cell.y, cell.z)] >> cell.x; }

private:
    static constexpr int WIDTH = BrickPoints::BLOCK_SIDE + 2 * REACH;

    static std::size_t placeOf(int y, int z) { return static_cast<std::size_t>(y + REACH + WIDTH * (z + REACH)); }

    static const Block& find(const CoveredCells& cells, const glm::ivec3& block)
    {
        static constexpr Block EMPTY{};
        const Block* found = cells.find(block);
        return found ? *found : EMPTY;
    }

    /** Add the rows of three blocks along x. @param y, z the place of these from that of the block, -1 to 1. */
    void add(const std::array<std::reference_wrapper<const Block>, 3>& blocks, int y, int z)
    {
        constexpr int LENGTH = BrickPoints::BLOCK_SIDE;
        const glm::ivec2 first = LENGTH * glm::ivec2(y, z);
        const glm::ivec2 begin = glm::max(first, -REACH);
        const glm::ivec2 end = glm::min(first + LENGTH, LENGTH + REACH);
        for (glm::ivec2 place = begin; place.y < end.y; ++place.y)
            for (place.x = begin.x; place.x < end.x; ++place.x)
            {
                const glm::uvec2 in(place - first);
                const auto rowOf = [&](std::size_t block) -> std::uint32_t { return blocks[block].get()[in.y][in.x]; };
                _rows[placeOf(place.x, place.y)] = rowOf(0) >> (LENGTH - REACH) | rowOf(1) << REACH |
                                                   (rowOf(2) << (LENGTH + REACH) & ((1u << WIDTH) - 1u));
            }
    }

    std::array<std::uint32_t, std::size_t{WIDTH} * WIDTH> _rows{};
};

constexpr std::size_t NUM_SQUARES = 512; // of 3 x 3 cells, as bits x + 3 * y

/** For each square of cells at z, -1 to 1, the bits of its cells beside edges and at corners. */
using SquareBits = std::array<std::uint32_t, NUM_SQUARES>;

/** The bit of the cell at a place from -1 to 1; none for those that are beside a side, and in the middle. */
constexpr std::uint32_t bitOf(int x, int y, int z)
{
    const auto isUpper = [](int place) { return static_cast<unsigned int>(place > 0); };
    if (x != 0 && y != 0 && z != 0) return 1u << (12 + isUpper(x) + 2 * isUpper(y) + 4 * isUpper(z));
    if (x == 0 && y != 0 && z != 0) return 1u << (isUpper(y) + 2 * isUpper(z));
    if (y == 0 && x != 0 && z != 0) return 1u << (4 + isUpper(z) + 2 * isUpper(x));
    if (z == 0 && x != 0 && y != 0) return 1u << (8 + isUpper(x) + 2 * isUpper(y));
    return 0;
}

constexpr SquareBits createSquareBits(int z)
{
    SquareBits all{};
    for (std::size_t square = 0; square < NUM_SQUARES; ++square)
        for (int cell = 0; cell < 9; ++cell)
            if (square >> cell & 1u) all[square] |= bitOf(cell % 3 - 1, cell / 3 - 1, z);
    return all;
}

/** Each square of cells with both axes exchanged. */
constexpr SquareBits createExchanged()
{
    SquareBits all{};
    for (std::size_t square = 0; square < NUM_SQUARES; ++square)
        for (int cell = 0; cell < 9; ++cell)
            if (square >> cell & 1u) all[square] |= 1u << (cell / 3 + 3 * (cell % 3));
    return all;
}

/** Collects the bits of a brick's neighbours. */
class NeighborBits
{
public:
    /** @param cell from the lower corner of the block. */
    NeighborBits(const Surroundings& surroundings, const glm::ivec3& cell) : _surroundings(surroundings), _cell(cell)
    {
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y)
                _rows[static_cast<std::size_t>(y + 1 + 3 * (z + 1))] = getRow(y, z);
    }

    BrickNeighbors find(unsigned int openSides)
    {
        static constexpr std::array<SquareBits, 3> SQUARES{createSquareBits(-1), createSquareBits(0),
                                                           createSquareBits(1)};
        add(SQUARES[0][joinRows(_rows[0], _rows[1], _rows[2])] | SQUARES[1][joinRows(_rows[3], _rows[4], _rows[5])] |
                SQUARES[2][joinRows(_rows[6], _rows[7], _rows[8])],
            20);
        const int numLayers = std::popcount(openSides) < 5 ? 2 : 1;
        for (unsigned int left = openSides; left != 0; left &= left - 1)
        {
            const int side = std::countr_zero(left);
            for (int layer = 0; layer < numLayers; ++layer)
                add(findLayer(side / 2, side % 2 == 1 ? 2 + layer : -2 - layer), 9);
        }
        return _bits;
    }

private:
    std::uint32_t getRow(int y, int z) const { return _surroundings.getRow(_cell + glm::ivec3(0, y, z)); }

    /** The square of the cells at x, -1 to 1, in three rows. */
    static std::uint32_t joinRows(std::uint32_t first, std::uint32_t second, std::uint32_t third)
    {
        const auto cellsOf = [](std::uint32_t row) { return row >> (REACH - 1) & 7u; };
        return cellsOf(first) | cellsOf(second) << 3 | cellsOf(third) << 6;
    }

    void add(std::uint64_t bits, unsigned int count)
    {
        bits <<= _next % 32;
        _bits[_next / 32] |= static_cast<std::uint32_t>(bits);
        if (bits >> 32 != 0) _bits[_next / 32 + 1] |= static_cast<std::uint32_t>(bits >> 32);
        _next += count;
    }

    /** The nine cells at a distance from the brick, with axes in the order of BrickNeighbors. */
    std::uint32_t findLayer(int axis, int distance) const
    {
        static constexpr SquareBits EXCHANGED = createExchanged();
        if (axis == 2) return joinRows(getRow(-1, distance), getRow(0, distance), getRow(1, distance));
        if (axis == 1) return EXCHANGED[joinRows(getRow(distance, -1), getRow(distance, 0), getRow(distance, 1))];
        std::uint32_t bits = 0;
        for (std::size_t row = 0; row < _rows.size(); ++row)
            bits |= (_rows[row] >> (distance + REACH) & 1u) << row;
        return bits;
    }

    const Surroundings& _surroundings;
    glm::ivec3 _cell;
    std::array<std::uint32_t, 9> _rows{}; // of cells along x, (y + 1) + 3 * (z + 1)
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
            const glm::ivec3 cell(getCell(points[index]) % BLOCK_CELLS);
            result[index] = NeighborBits(surroundings, cell).find(points[index][1] >> 16 & 63u);
        }
    };
    // Isolated: while it waits here, the thread must not run tasks of the caller, which may need locks that it holds.
    oneapi::tbb::this_task_arena::isolate([&]
                                          { oneapi::tbb::parallel_for(std::size_t(0), runs.size(), findNeighbors); });
    return result;
}

} // namespace osgLego
