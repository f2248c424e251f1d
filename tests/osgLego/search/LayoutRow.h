#pragma once

#include "../layout/LaidModel.h"

#include <osgLego/layout/PartMap.h>
#include <osgLego/search/LayoutRegion.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego
{

/** Two layers of four cells in a row, covered by parts of given lengths. */
class LayoutRow
{
public:
    static constexpr LayoutColor ONLY_SINGLE_AND_DOUBLE{0b11, 0b11};

    explicit LayoutRow(const std::vector<std::vector<int>>& lengths) :
        problem(makeCells({4, 1, 2}, [](int, int, int) { return 0; }, {ONLY_SINGLE_AND_DOUBLE}))
    {
        CellLattice::Index cell = 0;
        for (const std::vector<int>& layer : lengths)
            for (const int length : layer)
            {
                map.lay(cell, {static_cast<std::uint8_t>(length), 1, 1});
                cell += length;
            }
    }

    int countComponents() const
    {
        LaidParts parts;
        for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
            if (map.isAnchor(cell))
                parts.push_back(
                    {problem.cells[static_cast<std::size_t>(cell)].place, {map.getShape(cell).width, 1, 1}, 0});
        return LaidModel(problem, parts).countComponents();
    }

    LayoutProblem problem;
    CellLattice lattice{problem};
    PartSizes sizes{problem};
    PartMap map{lattice};
    LayoutRegion region{0, 2, 0, 1, 0, 0, nullptr};
};

} // namespace osgLego
