#include <osgLego/model/PartGroups.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** Two posts of three bricks, a beam on both, and bricks that hang from the beam: three at the left, one beside them,
 * one at the right. */
LaidParts createGate()
{
    return {{{0, 0, 0}, {1, 1, 1}}, {{9, 0, 0}, {1, 1, 1}}, {{0, 0, 1}, {1, 1, 1}}, {{2, 0, 1}, {2, 1, 1}},
            {{9, 0, 1}, {1, 1, 1}}, {{0, 0, 2}, {1, 1, 1}}, {{2, 0, 2}, {1, 1, 1}}, {{3, 0, 2}, {1, 1, 1}},
            {{4, 0, 2}, {1, 1, 1}}, {{7, 0, 2}, {1, 1, 1}}, {{9, 0, 2}, {1, 1, 1}}, {{0, 0, 3}, {10, 1, 1}}};
}

TEST(PartGroups, PartsThatNoPathLeadsUpToHangInGroupsOfJoinedParts)
{
    EXPECT_EQ(findHangingGroups(createGate()), (PartGroups{{3, 6, 7}, {8}, {9}}));
    EXPECT_TRUE(findHangingGroups({{{0, 0, 0}, {2, 2, 1}}, {{1, 0, 1}, {8, 2, 1}}}).empty());
    EXPECT_TRUE(findHangingGroups({}).empty());
}

TEST(PartGroups, PartsOfATouchingGroupLieSideBySideOrOnEachOther)
{
    EXPECT_EQ(findTouchingGroups(createGate(), {3, 6, 7, 8, 9}), (PartGroups{{3, 6, 7, 8}, {9}}));
    EXPECT_EQ(findTouchingGroups(createGate(), {0, 3, 8}), (PartGroups{{0}, {3}, {8}}));
    EXPECT_EQ(findTouchingGroups(createGate(), {9, 10, 11}), (PartGroups{{9, 10, 11}}));
}

} // namespace

} // namespace osgLego
