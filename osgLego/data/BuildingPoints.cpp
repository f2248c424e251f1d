#include <osgLego/data/BuildingPoints.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace osgLego
{

namespace
{

/** The ranks of all cells of a model, in the order of its bricks. */
class RankTable
{
public:
    RankTable(const BrickModel& model, std::span<const std::uint32_t> ranks) :
        _bricks(model.getBricks()), _parts(model.getPartIndices()), _table(_bricks.size())
    {
        for (std::size_t cell = 0; cell < _table.size(); ++cell)
            _table[cell].own = ranks[partOf(cell)];
        for (std::size_t axis = 0; axis < 3; ++axis)
            joinAlong(axis);
    }

    const std::vector<CellRanks>& get() const { return _table; }

private:
    std::size_t partOf(std::size_t cell) const { return _parts.empty() ? cell : _parts[cell]; }

    static std::tuple<int, int, int> keyOf(const std::array<std::uint16_t, 3>& cell)
    {
        return {cell[2], cell[1], cell[0]};
    }

    /** Set the ranks of neighbours on both sides of an axis. Bricks are sorted, so that their upper neighbours are in
     * the same order. */
    void joinAlong(std::size_t axis)
    {
        std::size_t next = 0;
        for (std::size_t cell = 0; cell < _table.size(); ++cell)
        {
            std::array<std::uint16_t, 3> above = _bricks[cell].cell;
            ++above[axis];
            while (next < _table.size() && keyOf(_bricks[next].cell) < keyOf(above))
                ++next;
            if (next == _table.size() || _bricks[next].cell != above) continue;
            const bool isJoined = partOf(cell) == partOf(next);
            _table[cell].upper[axis] = isJoined ? 0 : _table[next].own;
            _table[next].lower[axis] = isJoined ? 0 : _table[cell].own;
        }
    }

    const std::vector<Brick>& _bricks;
    const std::vector<std::uint32_t>& _parts;
    std::vector<CellRanks> _table;
};

/** The sides (BrickSide bits) of a cell that are open at some time. */
std::uint8_t findEverOpen(const CellRanks& ranks)
{
    std::uint8_t sides = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        if (ranks.lower[axis] > ranks.own) sides |= static_cast<std::uint8_t>(SIDE_LEFT << (2 * axis));
        if (ranks.upper[axis] > ranks.own) sides |= static_cast<std::uint8_t>(SIDE_RIGHT << (2 * axis));
    }
    return sides;
}

/** The number of parts in place from which on a cell is always hidden. */
std::uint32_t findLastRank(const CellRanks& ranks)
{
    return std::max(std::ranges::max(ranks.lower), std::ranges::max(ranks.upper));
}

/** The place of a cell's block in the order of blocks: those with studs before the others, layer by layer. */
std::tuple<int, bool, int, int> blockKeyOf(const Brick& brick, int stud)
{
    const glm::ivec3 place = brick.getCell() / BrickPoints::BLOCK_SIDE;
    return {place.z, !(brick.openSides & stud), place.y, place.x};
}

void include(const Brick& brick, const CellRanks& ranks, BrickBlock& block)
{
    const bool isFirst = block.count == 0;
    block.include(brick);
    block.firstRank = isFirst ? ranks.own : std::min(block.firstRank, ranks.own);
    block.lastRank = isFirst ? findLastRank(ranks) : std::max(block.lastRank, findLastRank(ranks));
}

} // namespace

BuildingPoints createBuildingPoints(const BrickModel& model, std::span<const std::uint32_t> ranks)
{
    const RankTable table(model, ranks);
    std::vector<Brick> cells = model.getBricks();
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
        cells[cell].openSides = findEverOpen(table.get()[cell]);

    const int up = model.getGrid().getUpIndex();
    const int stud = SIDE_RIGHT << (2 * up);
    std::vector<std::size_t> order(cells.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::erase_if(order, [&](std::size_t cell) { return cells[cell].openSides == 0; });
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b)
                     { return blockKeyOf(cells[a], stud) < blockKeyOf(cells[b], stud); });

    BuildingPoints result;
    result.points.reserve(order.size());
    result.ranks.reserve(order.size());
    for (const std::size_t cell : order)
    {
        const Brick& brick = cells[cell];
        const bool isNext =
            result.points.empty() || blockKeyOf(unpackBrick(result.points.back()), stud) != blockKeyOf(brick, stud);
        if (isNext) result.blocks.emplace_back().first = static_cast<int>(result.points.size());
        include(brick, table.get()[cell], result.blocks.back());
        result.points.push_back(model.getParts().empty()
                                    ? packBrick(brick)
                                    : packBrick(brick, model.getParts()[model.getPartIndices()[cell]], up));
        result.ranks.push_back(table.get()[cell]);
    }
    return result;
}

} // namespace osgLego
