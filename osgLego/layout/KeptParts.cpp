#include <osgLego/layout/KeptParts.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace osgLego
{

namespace
{

using Index = CellLattice::Index;

/** The cell at a place, or NONE. */
Index findCell(const LayoutProblem& problem, const std::array<std::uint16_t, 3>& place)
{
    const auto isBefore = [](const LayoutCell& cell, const std::array<std::uint16_t, 3>& other) {
        return std::array{cell.place[2], cell.place[1], cell.place[0]} < std::array{other[2], other[1], other[0]};
    };
    const auto cell = std::lower_bound(problem.cells.begin(), problem.cells.end(), place, isBefore);
    if (cell == problem.cells.end() || cell->place != place) return CellLattice::NONE;
    return static_cast<Index>(cell - problem.cells.begin());
}

/** Whether all cells of a part exist, are uncovered and may have its colour. */
bool fits(const PartMap& map, const LaidPart& part, Index anchor)
{
    const CellLattice& lattice = map.getLattice();
    Index level = anchor;
    for (int dz = 0; dz < part.size[2]; ++dz)
    {
        Index row = level;
        for (int dy = 0; dy < part.size[1]; ++dy)
        {
            Index cell = row;
            for (int dx = 0; dx < part.size[0]; ++dx)
            {
                if (cell == CellLattice::NONE || map.getAnchor(cell) != CellLattice::NONE) return false;
                const std::uint16_t color = lattice.getColor(cell);
                if (color != LayoutCell::ANY_COLOR && color != part.color) return false;
                cell = lattice.getNeighbor(cell, CellLattice::EAST);
            }
            row = lattice.getNeighbor(row, CellLattice::NORTH);
        }
        level = lattice.getNeighbor(level, CellLattice::ABOVE);
    }
    return true;
}

} // namespace

void keepParts(PartMap& map, const PartSizes& sizes, const LaidParts& previous)
{
    const LayoutProblem& problem = map.getLattice().getProblem();
    for (const LaidPart& part : previous)
    {
        const bool isKnown = part.color < problem.colors.size() &&
                             std::all_of(part.size.begin(), part.size.end(),
                                         [](int side) { return side >= 1 && side <= PartSizes::LONGEST; });
        if (!isKnown) continue;
        const PartShape shape{part.size[0], part.size[1], part.size[2]};
        const Index anchor = findCell(problem, part.place);
        if (anchor != CellLattice::NONE && sizes.isAllowed(shape, part.color) && fits(map, part, anchor))
            map.lay(anchor, shape);
    }
}

std::vector<bool> findChangedCells(const PartMap& map, int distance)
{
    const CellLattice& lattice = map.getLattice();
    std::vector<bool> isChanged(static_cast<std::size_t>(lattice.getNumCells()));
    std::vector<Index> reached;
    const auto reach = [&](Index cell)
    {
        if (cell == CellLattice::NONE || isChanged[static_cast<std::size_t>(cell)]) return;
        isChanged[static_cast<std::size_t>(cell)] = true;
        reached.push_back(cell);
    };
    for (Index cell = 0; cell < lattice.getNumCells(); ++cell)
        if (map.getAnchor(cell) == CellLattice::NONE) reach(cell);
    for (std::size_t begin = 0; distance > 0; --distance)
    {
        const std::size_t end = reached.size();
        for (; begin < end; ++begin)
            for (std::uint8_t side = 0; side < 6; ++side)
                reach(lattice.getNeighbor(reached[begin], static_cast<CellLattice::Side>(side)));
    }
    return isChanged;
}

} // namespace osgLego
