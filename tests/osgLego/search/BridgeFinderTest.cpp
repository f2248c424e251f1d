#include "LayoutRow.h"
#include "RandomLayout.h"

#include <osgLego/search/BridgeFinder.h>

#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(BridgeFinder, FindsTheBridgeThatAddsTheFewestParts)
{
    // A part of two cells in the middle adds one part, one of four cells takes one away.
    const LayoutProblem cells = drawProblem({{"aaaa"}, {"aaaa"}});
    LayoutRow row(cells, {{2, 2}, {2, 2}});
    UnionFind components;
    components.reset(8);
    for (const auto& [cell, other] : {std::pair(0, 1), {0, 4}, {0, 5}, {2, 3}, {2, 6}, {2, 7}})
        components.join(cell, other);
    BridgeFinder finder(row.map, row.sizes, components);
    const std::vector<PartCut::Piece> pieces = finder.find(1, CellLattice::EAST, row.region);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces.front().anchor, 0);
    EXPECT_EQ(pieces.front().shape, (PartShape{4, 1, 1}));
}

TEST(BridgeFinder, FindsBricksBesideBricks)
{
    LayoutProblem cells = drawProblem({{"aaaa"}, {"aaaa"}, {"aaaa"}, {"a..a"}});
    cells.isOfPlates = true;
    LaidMap laid(cells);
    laid.map.lay(0, {2, 1, 3});
    laid.map.lay(2, {2, 1, 3});
    laid.map.lay(12, {});
    laid.map.lay(13, {});
    UnionFind components;
    components.reset(14);
    for (const CellLattice::Index cell : {0, 1, 4, 5, 8, 9})
        components.join(12, cell);
    for (const CellLattice::Index cell : {2, 3, 6, 7, 10, 11})
        components.join(13, cell);
    const LayoutRegion region{0, 4, 0, 1, 0, 0, nullptr};
    const std::vector<PartCut::Piece> pieces =
        BridgeFinder(laid.map, laid.sizes, components).find(5, CellLattice::EAST, region);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces.front().shape, (PartShape{4, 1, 3}));
}

TEST(BridgeFinder, FindsBridgesThatJoinComponents)
{
    int numFound = 0;
    for (unsigned int seed = 0; seed < 40; ++seed)
    {
        RandomLayout laid(seed % 2 == 0 ? "aaab.." : "aa...", seed % 4 < 2, seed);
        UnionFind components;
        laid.map.findComponents(components);
        BridgeFinder finder(laid.map, laid.sizes, components);
        for (CellLattice::Index cell = 0; cell < laid.lattice.getNumCells(); ++cell)
            for (const auto side : {CellLattice::EAST, CellLattice::NORTH})
            {
                const CellLattice::Index other = laid.lattice.getNeighbor(cell, side);
                if (other == CellLattice::NONE || components.find(cell) == components.find(other)) continue;
                const int numComponents = laid.countComponents();
                const int numParts = laid.map.countParts();
                const std::vector<PartCut::Piece> pieces = finder.find(cell, side, laid.region);
                if (pieces.empty()) continue;
                for (const PartCut::Piece& piece : pieces)
                    laid.map.lay(piece.anchor, piece.shape);
                ++numFound;
                EXPECT_EQ(laid.map.getAnchor(cell), laid.map.getAnchor(other));
                ASSERT_LT(laid.countComponents(), numComponents) << "model " << seed;
                EXPECT_LE(laid.map.countParts(), numParts + 2);
                laid.map.findComponents(components);
            }
    }
    EXPECT_GT(numFound, 30);
}

} // namespace

} // namespace osgLego
