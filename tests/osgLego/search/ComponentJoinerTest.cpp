#include "LayoutRow.h"

#include <osgLego/search/ComponentJoiner.h>

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
