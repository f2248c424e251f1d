#include "LayoutRow.h"
#include "RandomLayout.h"

#include <Layouts.h>

#include <osgLego/search/LayoutCosts.h>
#include <osgLego/search/LayoutWindow.h>

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr int NODE_LIMIT = 1000;

TEST(LayoutWindow, LaysNoFewerPartsThatSeparateOthers)
{
    // Two parts of two cells would suffice in the upper layer, but only the one in the middle connects those below.
    LayoutRow row({{2, 2}, {1, 2, 1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_FALSE(window.improve(4, 3, LayoutCosts::HALF_SEAM, row.region, NODE_LIMIT, random));
    EXPECT_EQ(row.map.countParts(), 5);
    EXPECT_EQ(row.countComponents(), 1);
}

TEST(LayoutWindow, LaysFewerPartsThatSeparateNone)
{
    LayoutRow row({{1, 2, 1}, {1, 1, 1, 1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_TRUE(window.improve(4, 4, LayoutCosts::HALF_SEAM, row.region, NODE_LIMIT, random));
    EXPECT_EQ(row.map.countParts(), 5);
    EXPECT_EQ(row.countComponents(), 1);
}

TEST(LayoutWindow, NeverSeparatesParts)
{
    std::mt19937 engine(5);
    LayoutRandom random(1);
    int numChanges = 0;
    for (int i = 0; i < 24; ++i)
    {
        RandomLayout laid({6, 5, 4}, i % 3 == 0 ? "aaaaaa*." : "aab..", i % 2 == 0, static_cast<unsigned int>(engine()),
                          engine);
        LayoutWindow window(laid.map, laid.sizes);
        int numComponents = laid.countComponents();
        for (CellLattice::Index cell = 0; cell < laid.lattice.getNumCells(); ++cell)
        {
            const int numParts = 1 + static_cast<int>(random.below(8));
            if (!window.improve(laid.map.getAnchor(cell), numParts, 1000, laid.region, NODE_LIMIT, random)) continue;
            ++numChanges;
            const int numLeft = laid.countComponents();
            EXPECT_LE(numLeft, numComponents) << "model " << i << ", cell " << cell;
            numComponents = numLeft;
        }
    }
    EXPECT_GT(numChanges, 100);
}

TEST(LayoutWindow, JoinsTwoCellsByOnePart)
{
    std::mt19937 engine(6);
    LayoutRandom random(1);
    int numJoined = 0;
    for (int i = 0; i < 40; ++i)
    {
        RandomLayout laid({6, 5, 4}, "aab..", i % 2 == 0, static_cast<unsigned int>(engine()), engine);
        LayoutWindow window(laid.map, laid.sizes);
        int numComponents = laid.countComponents();
        for (CellLattice::Index cell = 0; cell < laid.lattice.getNumCells(); ++cell)
        {
            const CellLattice::Index other = laid.lattice.getNeighbor(cell, CellLattice::NORTH);
            if (other == CellLattice::NONE || laid.map.getAnchor(cell) == laid.map.getAnchor(other)) continue;
            if (!window.join(cell, other, 6, laid.region, LayoutCosts::COMPONENT, random)) continue;
            ++numJoined;
            EXPECT_EQ(laid.map.getAnchor(cell), laid.map.getAnchor(other));
            const int numLeft = laid.countComponents();
            EXPECT_LE(numLeft, numComponents) << "model " << i << ", cell " << cell;
            numComponents = numLeft;
        }
    }
    EXPECT_GT(numJoined, 40);
}

TEST(LayoutWindow, JoinsComponentsUpToTheGivenCost)
{
    // An additional part is necessary.
    LayoutRow row({{2, 2}, {2, 2}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_FALSE(window.join(1, 2, 4, row.region, 9000, random));
    EXPECT_TRUE(window.join(1, 2, 4, row.region, 11000, random));
    EXPECT_EQ(row.map.countParts(), 5);
}

TEST(LayoutWindow, JoinsMoreComponentsThanItSeparates)
{
    // The upper layer has parts of one and of three cells. The lower one has four parts, since neighbours differ in
    // colour. The part of three cells connects the first two; at the other end of the layer, it connects the last
    // three.
    constexpr std::array COLORS{0, 1, 1, 0, 1};
    constexpr LayoutColor ONLY_SINGLE_AND_TRIPLE{0b101, 0b101};
    LayoutRow row(makeCells({5, 1, 2},
                            [&](int x, int, int z) { return z == 1 ? 2 : COLORS[static_cast<std::size_t>(x)]; },
                            {LayoutColor{}, LayoutColor{}, ONLY_SINGLE_AND_TRIPLE}),
                  {{1, 2, 1, 1}, {3, 1, 1}});
    ASSERT_EQ(row.countComponents(), 3);
    row.region.zBegin = 1;
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_TRUE(window.join(8, 9, 3, row.region, LayoutCosts::COMPONENT, random));
    EXPECT_EQ(row.countComponents(), 2);
    EXPECT_EQ(row.map.countParts(), 7);
}

TEST(LayoutWindow, JoinsNoPartsOfOneComponent)
{
    LayoutRow row({{2, 2}, {1, 2, 1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    for (int numParts = 2; numParts <= 5; ++numParts)
        EXPECT_FALSE(window.join(1, 2, numParts, row.region, LayoutCosts::COMPONENT, random));
}

TEST(LayoutWindow, ReplacesThreePlatesByABrick)
{
    LayoutProblem plates = makeCells({1, 1, 3}, [](int, int, int) { return 0; });
    plates.isOfPlates = true;
    LayoutRow row(plates, {{1}, {1}, {1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_TRUE(window.improve(1, 3, LayoutCosts::HALF_SEAM, row.region, NODE_LIMIT, random));
    EXPECT_EQ(row.getParts(), (LaidParts{{{0, 0, 0}, {1, 1, 3}, 0}}));
}

TEST(LayoutWindow, KeepsToItsRegion)
{
    // Fewer parts suffice, but the parts next to the first one are outside.
    LayoutRow row({{1, 2, 1}, {1, 1, 1, 1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    row.region.zEnd = 1;
    EXPECT_FALSE(window.improve(4, 4, LayoutCosts::HALF_SEAM, row.region, NODE_LIMIT, random));
    row.region.zEnd = 2;
    EXPECT_TRUE(window.improve(4, 4, LayoutCosts::HALF_SEAM, row.region, NODE_LIMIT, random));
}

/** Two towers, two cells broad, that stand on a common part, and three parts on top, which may become two. */
struct Towers : LayoutRow
{
    static constexpr int NUM_LAYERS = 62;
    static constexpr CellLattice::Index TOP = 4 * (NUM_LAYERS - 1); //!< the first cell of the highest layer

    Towers() : LayoutRow(makeProblem(), makeLengths()) {}

    static LayoutProblem makeProblem()
    {
        return makeCells({4, 1, NUM_LAYERS}, [](int, int, int z) { return z == 0 ? 1 : 0; },
                         {ONLY_SINGLE_AND_DOUBLE, LayoutColor{}});
    }
    static std::vector<std::vector<int>> makeLengths()
    {
        std::vector<std::vector<int>> lengths(NUM_LAYERS, {2, 2});
        lengths.front() = {4};
        lengths.back() = {1, 2, 1};
        return lengths;
    }

    /** Lay the highest layer again. */
    bool improveTop()
    {
        LayoutWindow window(map, sizes);
        LayoutRandom random(1);
        return window.improve(TOP, 3, LayoutCosts::HALF_SEAM, region, NODE_LIMIT, random);
    }
};

TEST(LayoutWindow, FindsConnectionsFarAway)
{
    Towers towers;
    EXPECT_TRUE(towers.improveTop());
    EXPECT_EQ(towers.countComponents(), 1);
}

TEST(LayoutWindow, KnowsConnectionsOutsideOfItsRegionOnlyIfNoThreadChangesThem)
{
    Towers towers;
    std::vector<CellLattice::Index> components(static_cast<std::size_t>(towers.lattice.getNumCells()), 0);
    towers.region.zBegin = Towers::NUM_LAYERS - 1;
    EXPECT_FALSE(towers.improveTop());
    towers.region.fixedComponents = &components;
    EXPECT_TRUE(towers.improveTop());

    Towers separate;
    for (CellLattice::Index cell = 0; cell < separate.lattice.getNumCells(); ++cell)
        components[static_cast<std::size_t>(cell)] = cell % 4 < 2 ? 4 : 6;
    separate.region = towers.region;
    EXPECT_FALSE(separate.improveTop());
}

} // namespace

} // namespace osgLego
