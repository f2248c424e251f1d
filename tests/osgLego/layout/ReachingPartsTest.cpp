#include "LaidMap.h"
#include "LaidModel.h"

#include <osgLego/layout/GreedyLayout.h>
#include <osgLego/layout/ReachingParts.h>

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** A floor of one layer with a wall on its edge. */
LayoutProblem makeTray(int width, int depth)
{
    return makeCells({width, depth, 2}, [=](int x, int y, int z)
                     { return z == 0 || x == 0 || y == 0 || x == width - 1 || y == depth - 1 ? 0 : -1; });
}

int countComponents(LaidMap& laid)
{
    layGreedily(laid.map, laid.sizes);
    const LaidParts parts = laid.getParts();
    const LaidModel model(laid.problem, parts);
    EXPECT_EQ(model.findMistake(), "");
    return model.countComponents();
}

TEST(ReachingParts, ConnectTheMiddleOfAFlatPlace)
{
    for (const int width : {10, 12, 14, 16})
    {
        LaidMap greedy(makeTray(width, 30));
        LaidMap reaching(makeTray(width, 30));
        layReachingParts(reaching.map, reaching.sizes);
        EXPECT_LT(countComponents(reaching), countComponents(greedy)) << width;
    }
}

/** A floor with columns here and there. */
LayoutProblem makeColumns(int numColors, unsigned int seed)
{
    std::mt19937 random(seed);
    return makeCells(
        {18, 18, 2},
        [&](int, int, int z)
        { return z == 0 || random() % 40 == 0 ? static_cast<int>(random() % 16) / 15 % numColors : -1; },
        std::vector<LayoutColor>(2));
}

TEST(ReachingParts, AllContainACellWithAnotherAboveOrBelow)
{
    int numParts = 0;
    for (unsigned int seed = 0; seed < 20; ++seed)
    {
        LaidMap laid(makeColumns(1 + static_cast<int>(seed % 2), seed));
        layReachingParts(laid.map, laid.sizes);
        for (CellLattice::Index cell = 0; cell < laid.lattice.getNumCells(); ++cell)
        {
            if (!laid.map.isAnchor(cell)) continue;
            bool isConnected = false;
            laid.map.visitPart(cell, [&](CellLattice::Index other) { isConnected |= laid.lattice.isInColumn(other); });
            EXPECT_TRUE(isConnected);
            ++numParts;
        }
        layGreedily(laid.map, laid.sizes);
        const LaidParts parts = laid.getParts();
        EXPECT_EQ(LaidModel(laid.problem, parts).findMistake(), "");
    }
    EXPECT_GT(numParts, 100);
}

TEST(ReachingParts, LeaveCellsThatNoPartConnects)
{
    LaidMap laid(makeTray(30, 30));
    layReachingParts(laid.map, laid.sizes);
    const CellLattice::Index middle = 15 * 30 + 15;
    EXPECT_EQ(laid.map.getAnchor(middle), CellLattice::NONE);
}

} // namespace

} // namespace osgLego
