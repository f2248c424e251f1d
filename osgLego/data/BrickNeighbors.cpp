#include <osgLego/data/BrickNeighbors.h>

#include <osgLego/data/CellKeys.h>
#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

namespace
{

constexpr int REACH = 3; // the greatest distance of a neighbour, in cells

constexpr int BLOCK_CELLS = BrickPoints::BLOCK_SIDE; // along each side
constexpr std::size_t NONE = SIZE_MAX;

/** Consecutive points in one block. */
struct Run
{
    std::size_t begin;
    std::size_t end;
    std::size_t next; // run in the same block, or NONE
};

/** The covered cells of a block, by the places along an axis and along the second axis after it; the bits are those
 * along the first axis after it. */
using Layers = std::array<std::array<std::uint8_t, BLOCK_CELLS>, BLOCK_CELLS>;

glm::uvec3 getCell(const BrickPoint& point)
{
    return {point[0] & 0xffffu, point[0] >> 16, point[1] & 0xffffu};
}

/** A block of cells, some of which are covered. */
struct Block
{
    glm::ivec3 place{0};
    std::size_t firstRun = NONE;
    std::array<Layers, 3> layers{}; // by axis

    /** Cover the cell of a point. */
    void add(const BrickPoint& point)
    {
        const glm::uvec3 cell = getCell(point) % static_cast<unsigned int>(BLOCK_CELLS);
        layers[0][cell.x][cell.z] |= static_cast<std::uint8_t>(1u << cell.y);
        layers[1][cell.y][cell.x] |= static_cast<std::uint8_t>(1u << cell.z);
        layers[2][cell.z][cell.y] |= static_cast<std::uint8_t>(1u << cell.x);
    }
};

/** The number of a point's block. Blocks begin at -1, beside the grid; no number is 0. */
CellKey getBlockKey(const BrickPoint& point)
{
    return toCellKey(glm::ivec3(getCell(point) / static_cast<unsigned int>(BLOCK_CELLS)) + 2);
}

std::vector<Run> findRuns(std::span<const BrickPoint> points)
{
    // Counted first, since new memory takes longer than that.
    const auto isFirst = [&](std::size_t index)
    { return index == 0 || getBlockKey(points[index]) != getBlockKey(points[index - 1]); };
    std::size_t count = 0;
    for (std::size_t index = 0; index < points.size(); ++index)
        count += isFirst(index) ? 1 : 0;
    std::vector<Run> runs;
    runs.reserve(count);
    for (std::size_t index = 0; index < points.size(); ++index)
    {
        if (isFirst(index)) runs.push_back({index, index, NONE});
        runs.back().end = index + 1;
    }
    return runs;
}

/** The blocks of points. */
class BlockTable
{
public:
    explicit BlockTable(std::span<const BrickPoint> points) : _runs(findRuns(points))
    {
        _slots.resize(std::bit_ceil(2 * _runs.size() + 1));
        _blocks.reserve(_runs.size());
        for (std::size_t run = 0; run < _runs.size(); ++run)
        {
            const BrickPoint& first = points[_runs[run].begin];
            Slot& slot = _slots[findSlot(getBlockKey(first))];
            if (slot.key == EMPTY)
            {
                slot = {getBlockKey(first), static_cast<std::uint32_t>(_blocks.size())};
                _blocks.push_back({glm::ivec3(getCell(first) / static_cast<unsigned int>(BLOCK_CELLS)), NONE, {}});
            }
            Block& block = _blocks[slot.block];
            _runs[run].next = std::exchange(block.firstRun, run);
            for (std::size_t index = _runs[run].begin; index < _runs[run].end; ++index)
                block.add(points[index]);
        }
    }

    const std::vector<Block>& getBlocks() const { return _blocks; }
    const std::vector<Run>& getRuns() const { return _runs; }

    /** The block at a place; null if none of its cells is covered. */
    const Block* find(const glm::ivec3& place) const
    {
        const Slot& slot = _slots[findSlot(toCellKey(place + 2))];
        return slot.key == EMPTY ? nullptr : &_blocks[slot.block];
    }

private:
    static constexpr CellKey EMPTY = 0;

    struct Slot
    {
        CellKey key = EMPTY;
        std::uint32_t block = 0;
    };

    /** The slot of a key, or the one that is free for it: the first such slot after its hash. */
    std::size_t findSlot(CellKey key) const
    {
        const std::size_t mask = _slots.size() - 1;
        std::size_t slot = (key * 0x9e3779b97f4a7c15ull >> 32) & mask;
        while (_slots[slot].key != EMPTY && _slots[slot].key != key)
            slot = (slot + 1) & mask;
        return slot;
    }

    std::vector<Run> _runs;
    // A hash table with open addressing, at least half of whose slots are free, since each block looks 26 others up.
    std::vector<Slot> _slots;
    std::vector<Block> _blocks;
};

/** A block and the 26 around it, x first; null for those without covered cells. */
using NearBlocks = std::array<const Block*, 27>;

NearBlocks findNearBlocks(const BlockTable& blocks, const glm::ivec3& place)
{
    NearBlocks found;
    std::size_t next = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                found[next++] = blocks.find(place + glm::ivec3(x, y, z));
    return found;
}

/** Along an axis, the squares of 3 x 3 cells across it around the cells of a block, and up to REACH outside. The axes
 * `u` and `v` of a square are the two that follow the axis. */
template <int AXIS>
class Squares
{
public:
    explicit Squares(const NearBlocks& blocks)
    {
        Rows rows{};
        for (std::size_t number = 0; number < blocks.size(); ++number)
        {
            const auto place = static_cast<int>(number);
            const glm::ivec3 step(place % 3 - 1, place / 3 % 3 - 1, place / 9 - 1);
            if (blocks[number]) add(blocks[number]->layers[AXIS], {step[AXIS], step[U], step[V]}, rows);
        }
        for (std::size_t layer = 0; layer < rows.size(); ++layer)
            for (std::size_t row = 0; row < BLOCK_CELLS; ++row)
                _joined[layer * BLOCK_CELLS + row] = std::uint32_t{rows[layer][row]} |
                                                     std::uint32_t{rows[layer][row + 1]} << BITS |
                                                     std::uint32_t{rows[layer][row + 2]} << (2 * BITS);
    }

    /** The squares along the axis through a cell: that around the cell, then those with higher coordinates, BLOCK_CELLS
     * apart; before it, those with lower ones. @param place, v of the cell in the block, along the axis and v. */
    const std::uint32_t* find(unsigned int place, unsigned int v) const
    {
        return &_joined[(place + REACH) * BLOCK_CELLS + v];
    }

    /** The bits of two squares, (u + 1) + 3 * (v + 1) + 9 for the second. @param u of their middles. */
    static std::uint32_t unpack(std::uint32_t first, std::uint32_t second, unsigned int u)
    {
        constexpr std::uint64_t BOTH = 1ull << 32 | 1ull;
        const std::uint64_t rows = (first | std::uint64_t{second} << 32) >> u;
        const std::uint64_t squares =
            (rows & 7u * BOTH) | (rows >> (BITS - 3) & 0x38u * BOTH) | (rows >> (2 * BITS - 6) & 0x1c0u * BOTH);
        return static_cast<std::uint32_t>(squares | squares >> (32 - 9));
    }

private:
    static constexpr int U = (AXIS + 1) % 3;
    static constexpr int V = (AXIS + 2) % 3;
    static constexpr int BITS = BLOCK_CELLS + 2; // of a row, with a cell on each side

    /** The rows of each layer, likewise. */
    using Rows = std::array<std::array<std::uint16_t, std::size_t{BITS}>, std::size_t{BLOCK_CELLS + 2 * REACH}>;

    /** Add the cells of a block. @param step to it, along the axis, u and v. */
    static void add(const Layers& layers, const glm::ivec3& step, Rows& rows)
    {
        if (step[1] == 0) addRows(layers, step, rows, [](unsigned int bits) { return bits << 1; });
        if (step[1] < 0) addRows(layers, step, rows, [](unsigned int bits) { return bits >> (BLOCK_CELLS - 1); });
        if (step[1] > 0)
            addRows(layers, step, rows, [](unsigned int bits) { return (bits & 1u) << (BLOCK_CELLS + 1); });
    }

    template <typename Move>
    static void addRows(const Layers& layers, const glm::ivec3& step, Rows& rows, const Move& move)
    {
        const int begin = std::max(BLOCK_CELLS * step[0], -REACH);
        const int end = std::min(BLOCK_CELLS * step[0] + BLOCK_CELLS, BLOCK_CELLS + REACH);
        const auto add = [&](std::uint16_t& row, std::uint8_t bits) { row |= static_cast<std::uint16_t>(move(bits)); };
        for (int layer = begin; layer < end; ++layer)
        {
            const auto& added = layers[static_cast<std::size_t>(layer - BLOCK_CELLS * step[0])];
            auto& row = rows[static_cast<std::size_t>(layer + REACH)];
            if (step[2] < 0) add(row[0], added[BLOCK_CELLS - 1]);
            if (step[2] > 0) add(row[BLOCK_CELLS + 1], added[0]);
            if (step[2] == 0)
                for (std::size_t place = 0; place < BLOCK_CELLS; ++place)
                    add(row[place + 1], added[place]);
        }
    }

    std::array<std::uint32_t, std::size_t{BLOCK_CELLS * (BLOCK_CELLS + 2 * REACH)}>
        _joined; // three rows, from the one before v on
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

/** The open sides of a brick. */
struct OpenSides
{
    std::array<std::uint8_t, 6> sides{};
    std::uint8_t count = 0;
};

constexpr std::array<OpenSides, 64> createOpenSides()
{
    std::array<OpenSides, 64> all{};
    for (std::size_t bits = 0; bits < all.size(); ++bits)
        for (unsigned int side = 0; side < 6; ++side)
            if (bits >> side & 1u) all[bits].sides[all[bits].count++] = static_cast<std::uint8_t>(side);
    return all;
}

/** The cells of a block and around it. */
class Surroundings
{
public:
    explicit Surroundings(const NearBlocks& blocks) : _alongX(blocks), _alongY(blocks), _alongZ(blocks) {}

    /** The neighbours of a brick in the block. */
    BrickNeighbors find(const BrickPoint& point) const
    {
        static constexpr std::array<SquareBits, 3> SQUARES{createSquareBits(-1), createSquareBits(0),
                                                           createSquareBits(1)};
        static constexpr std::array<OpenSides, 64> OPEN_SIDES = createOpenSides();
        const unsigned int x = point[0] % BLOCK_CELLS;
        const unsigned int y = (point[0] >> 16) % BLOCK_CELLS;
        const unsigned int z = point[1] % BLOCK_CELLS;
        const std::array lines{_alongX.find(x, z), _alongY.find(y, x), _alongZ.find(z, y)};
        const std::array places{y, z, x};
        const auto unpack = [&](std::size_t axis, int first, int second) {
            return Squares<0>::unpack(lines[axis][first * BLOCK_CELLS], lines[axis][second * BLOCK_CELLS],
                                      places[axis]);
        };
        const OpenSides& open = OPEN_SIDES[point[1] >> 16 & 63u];
        const bool hasThird = open.count < 5;
        const std::uint32_t known = hasThird ? 0x3ffffu : 0x1ffu;
        std::array<std::uint32_t, 5> words{SQUARES[0][unpack(2, -1, -1) & 0x1ffu] |
                                           SQUARES[1][unpack(2, 0, 0) & 0x1ffu] | SQUARES[2][unpack(2, 1, 1) & 0x1ffu]};
        unsigned int next = 20;
        const auto add = [&](std::uint8_t side, std::uint64_t mask)
        {
            const int sign = side % 2 * 2 - 1;
            const std::uint64_t cells = unpack(side / 2, 2 * sign, 3 * sign) & mask;
            words[next / 32] |= static_cast<std::uint32_t>(cells << next % 32);
            words[next / 32 + 1] |= static_cast<std::uint32_t>(cells << next % 32 >> 32);
            next += hasThird ? 18 : 9;
        };
        // The number of sides is hard to predict: for most bricks, these two are all.
        add(open.sides[0], open.count > 0 ? known : 0);
        add(open.sides[1], open.count > 1 ? known : 0);
        for (std::size_t number = 2; number < open.count; ++number)
            add(open.sides[number], known);
        return {words[0], words[1], words[2]};
    }

private:
    Squares<0> _alongX;
    Squares<1> _alongY;
    Squares<2> _alongZ;
};

} // namespace

std::vector<BrickNeighbors> createBrickNeighbors(std::span<const BrickPoint> points)
{
    const BlockTable table(points);
    const std::vector<Run>& runs = table.getRuns();
    std::vector<BrickNeighbors> result(points.size());
    const auto findNeighbors = [&](const Block& block)
    {
        const Surroundings surroundings(findNearBlocks(table, block.place));
        for (std::size_t run = block.firstRun; run != NONE; run = runs[run].next)
            for (std::size_t index = runs[run].begin; index < runs[run].end; ++index)
                result[index] = surroundings.find(points[index]);
    };
    forEachIndex(table.getBlocks().size(), [&](std::size_t index) { findNeighbors(table.getBlocks()[index]); });
    return result;
}

} // namespace osgLego
