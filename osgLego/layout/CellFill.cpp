#include <osgLego/layout/CellFill.h>

#include <osgLego/data/UnionFind.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>

namespace osgLego
{

namespace
{

/** Empty cells of a row along x, from `begin` up to `end`. */
struct EmptyRun
{
    int begin = 0;
    int end = 0;
};

/** The empty cells of a grid as runs, and those that are inside. */
class EmptyCells
{
public:
    explicit EmptyCells(const BrickModel& model) : _size(model.getGrid().dimensions)
    {
        findRuns(model);
        UnionFind sets;
        sets.reset(_runs.size());
        joinRuns(sets);
        _isInside.resize(_runs.size());
        for (std::uint32_t run = 1; run < _runs.size(); ++run)
            _isInside[run] = sets.find(static_cast<std::int32_t>(run)) != OUTSIDE;
    }

    /** Call a function with y, z and the run for each run inside, in the order of cells. */
    template <typename Function>
    void forEachInside(Function function) const
    {
        for (std::size_t row = 0; row + 1 < _rows.size(); ++row)
            for (std::uint32_t run = _rows[row]; run < _rows[row + 1]; ++run)
                if (_isInside[run])
                    function(static_cast<int>(row) % _size.y, static_cast<int>(row) / _size.y, _runs[run]);
    }

private:
    void findRuns(const BrickModel& model)
    {
        _runs.push_back({});
        auto brick = model.getBricks().begin();
        for (int z = 0; z < _size.z; ++z)
            for (int y = 0; y < _size.y; ++y)
            {
                _rows.push_back(static_cast<std::uint32_t>(_runs.size()));
                int begin = 0;
                for (; brick != model.getBricks().end() && brick->cell[1] == y && brick->cell[2] == z; ++brick)
                {
                    if (begin < brick->cell[0]) _runs.push_back({begin, brick->cell[0]});
                    begin = brick->cell[0] + 1;
                }
                if (begin < _size.x) _runs.push_back({begin, _size.x});
            }
        _rows.push_back(static_cast<std::uint32_t>(_runs.size()));
    }

    void joinRuns(UnionFind& sets) const
    {
        for (int z = 0; z < _size.z; ++z)
            for (int y = 0; y < _size.y; ++y)
            {
                const std::size_t row = rowOf(y, z);
                const bool isAtEdge = y == 0 || z == 0 || y == _size.y - 1 || z == _size.z - 1;
                for (std::uint32_t run = _rows[row]; run < _rows[row + 1]; ++run)
                    if (isAtEdge || _runs[run].begin == 0 || _runs[run].end == _size.x)
                        sets.join(OUTSIDE, static_cast<std::int32_t>(run));
                if (y > 0) joinRows(rowOf(y - 1, z), row, sets);
                if (z > 0) joinRows(rowOf(y, z - 1), row, sets);
            }
    }

    /** Join the runs of two adjacent rows where they overlap. */
    void joinRows(std::size_t rowA, std::size_t rowB, UnionFind& sets) const
    {
        std::uint32_t a = _rows[rowA];
        std::uint32_t b = _rows[rowB];
        while (a < _rows[rowA + 1] && b < _rows[rowB + 1])
        {
            if (_runs[a].begin < _runs[b].end && _runs[b].begin < _runs[a].end)
                sets.join(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
            ++(_runs[a].end < _runs[b].end ? a : b);
        }
    }

    std::size_t rowOf(int y, int z) const
    {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(_size.y) + static_cast<std::size_t>(y);
    }

    static constexpr std::int32_t OUTSIDE = 0; // the run that stands for the outside of the grid

    glm::ivec3 _size;
    std::vector<EmptyRun> _runs;
    std::vector<std::uint32_t> _rows; // the first run of each row, and the number of runs
    std::vector<bool> _isInside;
};

/** Whether a cell comes before another one in the order of their numbers. */
bool isInOrder(const glm::ivec3& a, const glm::ivec3& b)
{
    return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
}

/** Lower the distance of each cell to 1 more than that of its neighbour in one of three directions; an empty neighbour
 * has the distance 0. Goes through the cells forwards if `step` is -1, and backwards if it is 1. */
void lowerDistances(const std::vector<Brick>& bricks, int step, std::vector<std::uint16_t>& distances)
{
    const auto count = static_cast<std::ptrdiff_t>(bricks.size());
    const std::ptrdiff_t first = step < 0 ? 0 : count - 1;
    std::array<std::ptrdiff_t, 3> neighbours{first, first, first};
    for (std::ptrdiff_t brick = first; brick >= 0 && brick < count; brick -= step)
        for (int axis = 0; axis < 3; ++axis)
        {
            glm::ivec3 wanted = bricks[static_cast<std::size_t>(brick)].getCell();
            wanted[axis] += step;
            // Neighbours come in the same order as the cells, so the search only ever moves on.
            std::ptrdiff_t& neighbour = neighbours[static_cast<std::size_t>(axis)];
            const auto cellOf = [&] { return bricks[static_cast<std::size_t>(neighbour)].getCell(); };
            while (neighbour != brick && (step < 0 ? isInOrder(cellOf(), wanted) : isInOrder(wanted, cellOf())))
                neighbour -= step;
            const bool isEmpty = cellOf() != wanted;
            std::uint16_t& distance = distances[static_cast<std::size_t>(brick)];
            const int other = isEmpty ? 0 : distances[static_cast<std::size_t>(neighbour)];
            distance = static_cast<std::uint16_t>(std::min(static_cast<int>(distance), other + 1));
        }
}

/** Remove the interior cells further from the outside than `shell` steps. */
void hollow(unsigned int shell, FilledCells& cells)
{
    // Larger than any distance: at most half the width of a grid.
    std::vector<std::uint16_t> distances(cells.bricks.size(), std::numeric_limits<std::int16_t>::max());
    lowerDistances(cells.bricks, -1, distances);
    lowerDistances(cells.bricks, 1, distances);
    std::size_t kept = 0;
    for (std::size_t index = 0; index < cells.bricks.size(); ++index)
    {
        if (cells.isInterior[index] && distances[index] > shell) continue;
        cells.bricks[kept] = cells.bricks[index];
        cells.isInterior[kept++] = cells.isInterior[index];
    }
    cells.isHollow = kept < cells.bricks.size();
    cells.numInterior -= cells.bricks.size() - kept;
    cells.bricks.resize(kept);
    cells.isInterior.resize(kept);
}

/** All covered and interior cells. */
FilledCells fillSolid(const BrickModel& model, const EmptyCells& empty, std::size_t numInterior)
{
    const std::vector<Brick>& covered = model.getBricks();
    FilledCells cells;
    cells.numInterior = numInterior;
    cells.bricks.reserve(covered.size() + numInterior);
    cells.isInterior.reserve(covered.size() + numInterior);
    auto next = covered.begin();
    empty.forEachInside(
        [&](int y, int z, const EmptyRun& run)
        {
            // The run begins behind a covered cell.
            for (; next != covered.end() && isInOrder(next->getCell(), {run.begin, y, z}); ++next)
            {
                cells.bricks.push_back(*next);
                cells.isInterior.push_back(false);
            }
            Brick brick = cells.bricks.back();
            for (int x = run.begin; x < run.end; ++x)
            {
                brick.cell[0] = static_cast<std::uint16_t>(x);
                cells.bricks.push_back(brick);
                cells.isInterior.push_back(true);
            }
        });
    cells.bricks.insert(cells.bricks.end(), next, covered.end());
    cells.isInterior.resize(cells.bricks.size(), false);
    return cells;
}

} // namespace

bool fillCells(const BrickModel& model, Fill fill, unsigned int shell, FilledCells& cells, std::string& error)
{
    if (fill == Fill::SURFACE)
    {
        cells = {model.getBricks(), std::vector<bool>(model.getBricks().size(), false), 0};
        return true;
    }
    const EmptyCells empty(model);
    std::size_t numInterior = 0;
    empty.forEachInside([&](int, int, const EmptyRun& run)
                        { numInterior += static_cast<std::size_t>(run.end - run.begin); });
    const std::size_t count = model.getBricks().size() + numInterior;
    if (count > GridLimits::MOST_BRICKS)
    {
        error = "the filled model has " + std::to_string(count) + " cells; expected at most " +
                std::to_string(GridLimits::MOST_BRICKS) + ", as at a lower resolution";
        return false;
    }
    cells = fillSolid(model, empty, numInterior);
    if (fill == Fill::SHELL) hollow(shell, cells);
    return true;
}

} // namespace osgLego
