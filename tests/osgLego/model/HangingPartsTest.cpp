#include <osgLego/model/HangingParts.h>

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(HangingParts, AreThoseThatNoPathLeadsUpTo)
{
    // A bridge on two posts, from whose middle a block hangs.
    const LaidParts parts{{{0, 0, 0}, {2, 2, 1}}, {{8, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {2, 2, 1}},
                          {{8, 0, 1}, {2, 2, 1}}, {{0, 0, 2}, {2, 2, 1}}, {{3, 0, 2}, {4, 2, 1}},
                          {{8, 0, 2}, {2, 2, 1}}, {{0, 0, 3}, {2, 2, 1}}, {{3, 0, 3}, {2, 2, 1}},
                          {{5, 0, 3}, {2, 2, 1}}, {{8, 0, 3}, {2, 2, 1}}, {{0, 0, 4}, {4, 2, 1}},
                          {{4, 0, 4}, {6, 2, 1}}, {{0, 0, 5}, {6, 2, 1}}, {{6, 0, 5}, {4, 2, 1}}};
    HangingParts hanging(parts);
    EXPECT_EQ(hanging.getGroups(), (std::vector<std::vector<std::uint32_t>>{{5, 8, 9}}));
    EXPECT_EQ(hanging.getCount(), 3u);
    EXPECT_EQ(hanging.findAbove(8), std::vector<std::uint32_t>{8});
    EXPECT_EQ(hanging.findAbove(5), (std::vector<std::uint32_t>{5, 8, 9}));
    EXPECT_TRUE(hanging.findAbove(0).empty());
    EXPECT_TRUE(hanging.isAt({6, 1, 2}));
    EXPECT_FALSE(hanging.isAt({7, 1, 2}));
    EXPECT_FALSE(hanging.isAt({4, 0, 4}));
    hanging.supportAt({3, 0, 3});
    EXPECT_EQ(hanging.getGroups(), (std::vector<std::vector<std::uint32_t>>{{5, 9}}));
    hanging.supportAt({0, 0, 0}); // does not hang
    hanging.supportAt({6, 1, 2});
    EXPECT_EQ(hanging.getCount(), 0u);
}

} // namespace

} // namespace osgLego
