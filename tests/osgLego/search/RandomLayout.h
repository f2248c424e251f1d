#pragma once

#include "../layout/LaidMap.h"
#include "../layout/LaidModel.h"

#include <Layouts.h>

#include <osgLego/data/UnionFind.h>
#include <osgLego/search/LayoutRegion.h>

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace osgLego
{

/** Random cells, covered by random parts. */
struct RandomLayout : LaidMap
{
    /** @param characters those of drawProblem(). */
    RandomLayout(const std::string& characters, bool isOfPlates, unsigned int seed) :
        LaidMap(makeProblem(characters, isOfPlates, seed))
    {
        std::mt19937 random(seed);
        layRandomly(random);
    }

    static LayoutProblem makeProblem(const std::string& characters, bool isOfPlates, unsigned int seed)
    {
        LayoutProblem cells = createRandomProblem({7, 6, 5}, characters, seed);
        cells.isOfPlates = isOfPlates;
        return cells;
    }

    /** Count the components. Fails if a cell is not covered once by a part that exists. */
    int countComponents() const
    {
        const LaidParts parts = getParts();
        const LaidModel model(problem, parts);
        EXPECT_EQ(model.findMistake(), "");
        return model.countComponents();
    }

    /** The components of cells. */
    UnionFind findComponents() const
    {
        UnionFind components;
        components.reset(static_cast<std::size_t>(lattice.getNumCells()));
        for (CellLattice::Index cell = 0; cell < lattice.getNumCells(); ++cell)
        {
            components.join(cell, map.getAnchor(cell));
            const CellLattice::Index above = lattice.getNeighbor(cell, CellLattice::ABOVE);
            if (above != CellLattice::NONE) components.join(cell, above);
        }
        return components;
    }

    LayoutRegion region{0, 5, 0, 6, 0, 0, nullptr};
};

} // namespace osgLego
