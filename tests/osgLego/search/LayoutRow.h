#pragma once

#include "../layout/LaidMap.h"
#include "../layout/LaidModel.h"

#include <osgLego/search/LayoutRegion.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace osgLego
{

/** Layers of cells in a row, all of one colour, covered by parts of given lengths. */
struct LayoutRow : LaidMap
{
    static constexpr LayoutColor ONLY_SINGLE_AND_DOUBLE{0b11, 0b11};

    /** Two layers of four cells. */
    explicit LayoutRow(const std::vector<std::vector<int>>& lengths) :
        LayoutRow(makeCells({4, 1, 2}, [](int, int, int) { return 0; }, {ONLY_SINGLE_AND_DOUBLE}), lengths)
    {
    }

    LayoutRow(LayoutProblem cells, const std::vector<std::vector<int>>& lengths) : LaidMap(std::move(cells))
    {
        CellLattice::Index cell = 0;
        for (const std::vector<int>& layer : lengths)
            for (const int length : layer)
            {
                map.lay(cell, {static_cast<std::uint8_t>(length), 1, 1});
                cell += length;
            }
    }

    LayoutRegion region{0, lattice.getNumLayers(), 0, 1, 0, 0, nullptr};
};

} // namespace osgLego
