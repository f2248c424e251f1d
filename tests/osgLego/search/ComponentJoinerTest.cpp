#include "LayoutRow.h"

#include <Layouts.h>

#include <osgLego/layout/PossibleComponents.h>
#include <osgLego/search/ComponentJoiner.h>

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(ComponentJoiner, JoinsComponentsAtTheCostOfAPart)
{
    LayoutRow row({{2, 2}, {2, 2}});
    ASSERT_EQ(row.countComponents(), 2);
    LayoutRandom random(1);
    EXPECT_TRUE(ComponentJoiner(row.map, row.sizes).joinAll({8, 100}, {}, random, {}));
    EXPECT_EQ(row.countComponents(), 1);
    EXPECT_EQ(row.map.countParts(), 5);
}

TEST(ComponentJoiner, JoinsComponentsInTheOnlyLayerThatAllowsIt)
{
    for (const auto& layers : {drawProblem({{"aa"}, {"bc"}}), drawProblem({{"bc"}, {"aa"}})})
    {
        LayoutRow row(layers, {{1, 1}, {1, 1}});
        LayoutRandom random(1);
        EXPECT_TRUE(ComponentJoiner(row.map, row.sizes).joinAll({8, 100}, {}, random, {}));
        EXPECT_EQ(row.countComponents(), 1);
    }
}

TEST(ComponentJoiner, TriesPairsAgainWhileItMay)
{
    int numExtra = 0;
    int numExtraAtFirst = 0;
    std::mt19937 engine(2);
    for (unsigned int seed = 0; seed < 30; ++seed)
    {
        LaidMap laid(createRandomProblem({6, 5, 4}, "aaaab", seed));
        laid.layRandomly(engine);
        LayoutRandom random(seed);
        ComponentJoiner joiner(laid.map, laid.sizes);
        const auto countExtra = [&laid]
        {
            const LaidParts parts = laid.getParts();
            return LaidModel(laid.problem, parts).countComponents() -
                   static_cast<int>(countPossibleComponents(laid.problem));
        };
        joiner.joinAll({1, 1}, {}, random, {});
        numExtraAtFirst += countExtra();
        joiner.joinAll({1, 300}, {}, random, {});
        numExtra += countExtra();
    }
    EXPECT_GT(numExtraAtFirst, 0);
    EXPECT_EQ(numExtra, 0);
}

TEST(ComponentJoiner, LeavesInactiveCellsAndStopsIfItIsCancelled)
{
    LayoutRow row({{2, 2}, {2, 2}});
    LayoutRandom random(1);
    ComponentJoiner joiner(row.map, row.sizes);
    EXPECT_TRUE(joiner.joinAll({8, 100}, std::vector<bool>(8, false), random, {}));
    EXPECT_FALSE(joiner.joinAll({8, 100}, {}, random, [] { return true; }));
    EXPECT_EQ(row.countComponents(), 2);
}

} // namespace

} // namespace osgLego
