#include <osgLego/layout/CellLattice.h>

#include <algorithm>

namespace osgLego
{

namespace
{

/** The order of cells, as a number. */
std::uint64_t getRank(const LayoutCell& cell, const std::array<int, 3>& step)
{
    const auto along = [&](std::size_t axis)
    { return static_cast<std::uint64_t>(cell.place[axis]) + static_cast<std::uint64_t>(step[axis]); };
    return along(2) << 40 | along(1) << 20 | along(0);
}

} // namespace

CellLattice::CellLattice(const LayoutProblem& problem) :
    _problem(problem), _layerStarts(static_cast<std::size_t>(std::max(problem.size.z, 0)) + 1),
    _neighbors(problem.cells.size(), {NONE, NONE, NONE, NONE, NONE, NONE})
{
    for (const LayoutCell& cell : problem.cells)
        ++_layerStarts[cell.place[2] + std::size_t(1)];
    for (std::size_t z = 1; z < _layerStarts.size(); ++z)
        _layerStarts[z] += _layerStarts[z - 1];
    link({1, 0, 0}, EAST, WEST);
    link({0, 1, 0}, NORTH, SOUTH);
    link({0, 0, 1}, ABOVE, BELOW);
}

/** Both sequences, cells and the places beside them, are sorted: a merge finds the cells in both. */
void CellLattice::link(const std::array<int, 3>& step, Side side, Side opposite)
{
    const std::vector<LayoutCell>& cells = _problem.cells;
    std::size_t other = 0;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
        const std::uint64_t rank = getRank(cells[cell], step);
        while (other < cells.size() && getRank(cells[other], {0, 0, 0}) < rank)
            ++other;
        if (other == cells.size()) return;
        if (getRank(cells[other], {0, 0, 0}) != rank) continue;
        _neighbors[cell][side] = static_cast<Index>(other);
        _neighbors[other][opposite] = static_cast<Index>(cell);
    }
}

} // namespace osgLego
