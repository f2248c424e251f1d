#include "LaidMap.h"

#include "LaidModel.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace osgLego
{

void LaidMap::layRandomly(std::mt19937& random)
{
    constexpr int NUM_ATTEMPTS = 6;
    const auto length = [&](int longest) { return static_cast<std::uint8_t>(1 + random() % unsigned(longest)); };
    for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
        for (int attempt = 0; map.getAnchor(cell) == CellLattice::NONE; ++attempt)
        {
            const int height = sizes.getHeights()[random() % sizes.getHeights().size()];
            const PartShape shape{length(4), length(4), static_cast<std::uint8_t>(height)};
            if (attempt == NUM_ATTEMPTS)
                map.lay(cell, {});
            else if (fits(cell, shape))
                map.lay(cell, shape);
        }
}

/** Whether a part can be laid; looks for each of its cells among all cells. */
bool LaidMap::fits(CellLattice::Index anchor, const PartShape& shape) const
{
    std::uint16_t color = LayoutCell::ANY_COLOR;
    int numCells = 0;
    for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
    {
        const auto isWithin = [](int place, int begin, int length) { return place >= begin && place < begin + length; };
        if (!isWithin(lattice.getX(cell), lattice.getX(anchor), shape.width) ||
            !isWithin(lattice.getY(cell), lattice.getY(anchor), shape.depth) ||
            !isWithin(lattice.getZ(cell), lattice.getZ(anchor), shape.height))
            continue;
        const auto joint = PartSizes::join(color, lattice.getColor(cell));
        if (!joint || map.getAnchor(cell) != CellLattice::NONE) return false;
        color = *joint;
        ++numCells;
    }
    return numCells == shape.getNumCells() && sizes.isAllowed(shape, color);
}

int LaidMap::countComponents() const
{
    const LaidParts parts = getParts();
    const LaidModel model(problem, parts);
    EXPECT_EQ(model.findMistake(), "");
    return model.countComponents();
}

} // namespace osgLego
