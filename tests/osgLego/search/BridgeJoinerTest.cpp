#include "LayoutRow.h"
#include "RandomLayout.h"

#include <osgLego/layout/GreedyLayout.h>
#include <osgLego/layout/PossibleComponents.h>
#include <osgLego/search/BridgeJoiner.h>

#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(BridgeJoiner, JoinsTheTowersOfAGreedyLayout)
{
    LayoutRow row({{2, 2}, {2, 2}});
    ASSERT_EQ(row.countComponents(), 2);
    LayoutRandom random(1);
    EXPECT_TRUE(BridgeJoiner(row.map, row.sizes).joinAll({}, random, {}));
    EXPECT_EQ(row.countComponents(), 1);
    EXPECT_EQ(row.map.countParts(), 5);
}

TEST(BridgeJoiner, MergesStripsWithTheirNeighbours)
{
    // The bridge in the middle leaves strips of two cells, which become parts of three cells with the parts beside
    // them.
    LayoutProblem cells = drawProblem({{"aaaaaaaa"}, {"aaaabbbb"}});
    cells.colors.assign(2, {0b1111, 0b1111});
    LayoutRow row(cells, {{1, 3, 3, 1}, {4, 4}});
    ASSERT_EQ(row.countComponents(), 2);
    LayoutRandom random(1);
    EXPECT_TRUE(BridgeJoiner(row.map, row.sizes).joinAll({}, random, {}));
    EXPECT_EQ(row.countComponents(), 1);
    EXPECT_EQ(row.map.countParts(), 5);
}

TEST(BridgeJoiner, DissolvesPartsThatTouchNoOther)
{
    LayoutRow row(drawProblem({{"aaaaaa"}, {"aa...."}}), {{2, 4}, {2}});
    ASSERT_EQ(row.countComponents(), 2);
    LayoutRandom random(1);
    EXPECT_TRUE(BridgeJoiner(row.map, row.sizes).joinAll({}, random, {}));
    EXPECT_EQ(row.countComponents(), 1);
}

TEST(BridgeJoiner, NeverSeparatesPartsAndJoinsMostThatCanBe)
{
    int numExtra = 0;
    int numExtraAtFirst = 0;
    for (unsigned int seed = 0; seed < 60; ++seed)
    {
        RandomLayout laid(seed % 3 == 0 ? "aab.." : "aaaab", seed % 2 == 0, seed);
        const int numAtFirst = laid.countComponents();
        const auto numPossible = static_cast<int>(countPossibleComponents(laid.problem));
        LayoutRandom random(seed);
        BridgeJoiner(laid.map, laid.sizes).joinAll({}, random, {});
        const int numLeft = laid.countComponents();
        EXPECT_LE(numLeft, numAtFirst) << "model " << seed;
        numExtraAtFirst += numAtFirst - numPossible;
        numExtra += numLeft - numPossible;
    }
    EXPECT_GT(numExtraAtFirst, 100);
    EXPECT_LT(numExtra, numExtraAtFirst / 4);
}

TEST(BridgeJoiner, LeavesInactiveCellsAndStopsIfItIsCancelled)
{
    LayoutRow row({{2, 2}, {2, 2}});
    LayoutRandom random(1);
    BridgeJoiner joiner(row.map, row.sizes);
    EXPECT_TRUE(joiner.joinAll(std::vector<bool>(8, false), random, {}));
    EXPECT_FALSE(joiner.joinAll({}, random, [] { return true; }));
    EXPECT_EQ(row.countComponents(), 2);
}

} // namespace

} // namespace osgLego
