#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/model/LayerColumns.h>
#include <osgLego/model/LayoutStanding.h>

#include <Layouts.h>

#include <functional>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

const std::function<bool()> NEVER;

/** A gate of two posts and a beam, from which a brick hangs. Its layers stand, but for that brick. */
SupportedLayout createGateWithABrick()
{
    const char* const posts = "a......a";
    const char* const beam = "aaaaaaaa";
    return {drawProblem({{posts}, {posts}, {"a..aa..a"}, {beam}, {beam}}),
            {{{0, 0, 0}},
             {{7, 0, 0}},
             {{0, 0, 1}},
             {{7, 0, 1}},
             {{0, 0, 2}},
             {{3, 0, 2}, {2, 1, 1}},
             {{7, 0, 2}},
             {{0, 0, 3}, {8, 1, 1}},
             {{0, 0, 4}, {8, 1, 1}}}};
}

/** With a tenth more cells. */
std::size_t getMostCells(const SupportedLayout& layout)
{
    return 11 * layout.problem.cells.size() / 10;
}

TEST(LayerColumns, CarryPartsThatFallWhenTheirLayerIsBuilt)
{
    const SupportedLayout layout = createGateWithABrick();
    ASSERT_EQ(findLayoutError(layout.problem, layout.parts), "");
    LayerColumns columns(layout, 0, NEVER);
    EXPECT_TRUE(columns.run(getMostCells(layout)));
    const SupportedLayout& changed = columns.getLayout();
    EXPECT_EQ(findLayoutError(changed.problem, changed.parts), "");
    EXPECT_EQ(changed.columns.size(), 1u);
    EXPECT_EQ(changed.numColumnParts, 2u);
    for (int layer = 0; layer < 5; ++layer)
    {
        LaidParts parts;
        for (const LaidPart& part : changed.parts)
            if (part.place[2] <= layer) parts.push_back(part);
        EXPECT_TRUE(computeStanding(changed.problem, parts, {})->stands) << layer;
    }
}

TEST(LayerColumns, AreNotAddedBelowGroupsThatBecomeSubmodels)
{
    const SupportedLayout layout = createGateWithABrick();
    LayerColumns columns(layout, 1, NEVER);
    EXPECT_TRUE(columns.run(getMostCells(layout)));
    EXPECT_EQ(columns.getLayout().parts, layout.parts);
}

TEST(LayerColumns, AreGivenUpIfTheyHaveManyCells)
{
    // A brick that hangs high above the ground.
    const char* const posts = "a......a";
    SupportedLayout layout{drawProblem({{posts}, {posts}, {posts}, {"a..aa..a"}, {"aaaaaaaa"}}), {}};
    for (std::uint16_t z = 0; z < 4; ++z)
    {
        layout.parts.push_back({{0, 0, z}});
        if (z == 3) layout.parts.push_back({{3, 0, z}, {2, 1, 1}});
        layout.parts.push_back({{7, 0, z}});
    }
    layout.parts.push_back({{0, 0, 4}, {8, 1, 1}});
    ASSERT_EQ(findLayoutError(layout.problem, layout.parts), "");
    EXPECT_FALSE(LayerColumns(layout, 0, NEVER).run(getMostCells(layout)));
    EXPECT_TRUE(LayerColumns(layout, 1, NEVER).run(getMostCells(layout)));
}

TEST(LayerColumns, AreNotNeededWhereAllLayersStand)
{
    const SupportedLayout layout{drawProblem({{"aaaa"}, {"aaaa"}}), {{{0, 0, 0}, {4, 1, 1}}, {{0, 0, 1}, {4, 1, 1}}}};
    LayerColumns columns(layout, 0, NEVER);
    EXPECT_TRUE(columns.run(getMostCells(layout)));
    EXPECT_EQ(columns.getLayout().parts, layout.parts);
    EXPECT_EQ(columns.getLayout().columns.size(), 0u);
}

TEST(LayerColumns, StopWhenTheyAreCancelled)
{
    const std::function<bool()> always = [] { return true; };
    EXPECT_FALSE(LayerColumns(createGateWithABrick(), 0, always).run(1000));
}

} // namespace

} // namespace osgLego
