#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/model/BuildingColumns.h>
#include <osgLego/model/LayoutStanding.h>

#include <Layouts.h>

#include <functional>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

const std::function<bool()> NEVER;

/** A bridge on two posts, from whose middle a block hangs. */
SupportedLayout createBridge()
{
    const LaidParts parts{{{0, 0, 0}, {2, 2, 1}}, {{8, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {2, 2, 1}},
                          {{8, 0, 1}, {2, 2, 1}}, {{0, 0, 2}, {2, 2, 1}}, {{3, 0, 2}, {4, 2, 1}},
                          {{8, 0, 2}, {2, 2, 1}}, {{0, 0, 3}, {2, 2, 1}}, {{3, 0, 3}, {2, 2, 1}},
                          {{5, 0, 3}, {2, 2, 1}}, {{8, 0, 3}, {2, 2, 1}}, {{0, 0, 4}, {4, 2, 1}},
                          {{4, 0, 4}, {6, 2, 1}}, {{0, 0, 5}, {6, 2, 1}}, {{6, 0, 5}, {4, 2, 1}}};
    const char* const posts = "aa......aa";
    const char* const block = "aa.aaaa.aa";
    const char* const beam = "aaaaaaaaaa";
    return {drawProblem({{posts, posts}, {posts, posts}, {block, block}, {block, block}, {beam, beam}, {beam, beam}}),
            parts};
}

TEST(BuildingColumns, CarryAGroupOfPartsThatIsTooLargeToHang)
{
    SupportedLayout layout = createBridge();
    ASSERT_EQ(findLayoutError(layout.problem, layout.parts), "");
    ASSERT_TRUE(computeStanding(layout.problem, layout.parts, {})->stands);
    ASSERT_TRUE(BuildingColumns(layout, NEVER, 2).run());
    EXPECT_EQ(findLayoutError(layout.problem, layout.parts), "");
    EXPECT_EQ(layout.numColumns, 1u);
    EXPECT_EQ(layout.numColumnParts, 2u);
    EXPECT_EQ(layout.numCarried, 3u);
    EXPECT_EQ(HangingParts(layout.parts).getCount(), 0u);
}

TEST(BuildingColumns, AreNotAddedWhereFewPartsHang)
{
    SupportedLayout layout = createBridge();
    const LaidParts parts = layout.parts;
    ASSERT_TRUE(BuildingColumns(layout, NEVER, 3).run());
    EXPECT_EQ(layout.parts, parts);
    EXPECT_EQ(layout.numCarried, 0u);
}

TEST(BuildingColumns, StopWhenTheyAreCancelled)
{
    SupportedLayout layout = createBridge();
    const LaidParts parts = layout.parts;
    const std::function<bool()> always = [] { return true; };
    EXPECT_FALSE(BuildingColumns(layout, always, 2).run());
    EXPECT_EQ(layout.parts, parts);
}

} // namespace

} // namespace osgLego
