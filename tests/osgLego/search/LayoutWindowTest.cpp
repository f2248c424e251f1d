#include "LayoutRow.h"

#include <osgLego/search/LayoutCosts.h>
#include <osgLego/search/LayoutWindow.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

constexpr int MANY_NODES = 1000;

TEST(LayoutWindow, LaysNoFewerPartsThatSeparateOthers)
{
    // Two parts of two cells would suffice in the upper layer, but only the one in the middle connects those below.
    LayoutRow row({{2, 2}, {1, 2, 1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_FALSE(window.improve(4, 3, LayoutCosts::HALF_SEAM, row.region, MANY_NODES, random));
    EXPECT_EQ(row.map.countParts(), 5);
    EXPECT_EQ(row.countComponents(), 1);
}

TEST(LayoutWindow, LaysFewerPartsThatSeparateNone)
{
    LayoutRow row({{1, 2, 1}, {1, 1, 1, 1}});
    LayoutWindow window(row.map, row.sizes);
    LayoutRandom random(1);
    EXPECT_TRUE(window.improve(4, 4, LayoutCosts::HALF_SEAM, row.region, MANY_NODES, random));
    EXPECT_EQ(row.map.countParts(), 5);
    EXPECT_EQ(row.countComponents(), 1);
}

} // namespace

} // namespace osgLego
