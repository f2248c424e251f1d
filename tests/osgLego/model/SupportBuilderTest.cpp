#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/model/LayoutStanding.h>
#include <osgLego/model/SupportBuilder.h>

#include <Layouts.h>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

SupportedLayout support(const LayoutProblem& problem, const LaidParts& parts)
{
    SupportedLayout layout{problem, parts};
    EXPECT_TRUE(SupportBuilder({}).build(layout));
    EXPECT_EQ(findLayoutError(layout.problem, layout.parts), "");
    return layout;
}

bool stands(const SupportedLayout& layout)
{
    return computeStanding(layout.problem, layout.parts, {})->stands;
}

TEST(SupportBuilder, LeavesAModelThatStandsUnchanged)
{
    const LayoutProblem problem = drawProblem({{"aa", "aa"}, {"aa", "aa"}});
    const LaidParts parts{{{0, 0, 0}, {2, 2, 1}}, {{0, 0, 1}, {2, 2, 1}}};
    const SupportedLayout layout = support(problem, parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_EQ(layout.parts, parts);
    EXPECT_EQ(layout.problem.cells, problem.cells);
}

TEST(SupportBuilder, LaysBricksAcrossTheWeakPlaceBeforeItAddsColumns)
{
    // A bridge on two posts, whose joints lie above each other beside a post.
    const LayoutProblem problem = drawProblem(
        {{"aa....aa", "aa....aa"}, {"aa....aa", "aa....aa"}, {"aaaaaaaa", "aaaaaaaa"}, {"aaaaaaaa", "aaaaaaaa"}});
    LaidParts parts;
    for (std::uint16_t z = 0; z < 2; ++z)
        for (const std::uint16_t x : {std::uint16_t(0), std::uint16_t(6)})
            parts.push_back({{x, 0, z}, {2, 2, 1}});
    for (std::uint16_t z = 2; z < 4; ++z)
    {
        parts.push_back({{0, 0, z}, {2, 2, 1}});
        parts.push_back({{2, 0, z}, {4, 2, 1}});
        parts.push_back({{6, 0, z}, {2, 2, 1}});
    }
    ASSERT_FALSE(stands({problem, parts}));
    const SupportedLayout layout = support(problem, parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_TRUE(stands(layout));
    EXPECT_TRUE(layout.isLaidAgain);
    EXPECT_EQ(layout.numColumns, 0u);
    EXPECT_EQ(layout.problem.cells, problem.cells);
}

TEST(SupportBuilder, PutsColumnsUnderAModelThatTipsOver)
{
    const LayoutProblem problem = drawProblem({{"a......."}, {"a......."}, {"aaaaaaaa"}});
    const LaidParts parts{{{0, 0, 0}}, {{0, 0, 1}}, {{0, 0, 2}, {8, 1, 1}}};
    ASSERT_FALSE(stands({problem, parts}));
    const SupportedLayout layout = support(problem, parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_TRUE(stands(layout));
    EXPECT_EQ(layout.numColumns, 1u);
    EXPECT_EQ(layout.numColumnParts, 2u);
    EXPECT_EQ(layout.parts.size(), parts.size() + 2);
}

TEST(SupportBuilder, PutsColumnsUnderPartsThatFloat)
{
    const LayoutProblem problem = drawProblem(
        {{"aa......", "aa......"}, {"aa......", "aa......"}, {"aa....aa", "aa....aa"}, {"aa....aa", "aa....aa"}});
    LaidParts parts;
    for (std::uint16_t z = 0; z < 4; ++z)
    {
        parts.push_back({{0, 0, z}, {2, 2, 1}});
        if (z >= 2) parts.push_back({{6, 0, z}, {2, 2, 1}});
    }
    const SupportedLayout layout = support(problem, parts);
    EXPECT_TRUE(layout.stands);
    EXPECT_TRUE(stands(layout));
    EXPECT_EQ(layout.numColumns, 1u);
    EXPECT_EQ(layout.numColumnParts, 2u);
}

TEST(SupportBuilder, CanBeCancelled)
{
    const LayoutProblem problem = drawProblem({{"a......."}, {"aaaaaaaa"}});
    SupportedLayout layout{problem, {{{0, 0, 0}}, {{0, 0, 1}, {8, 1, 1}}}};
    LayoutOptions options;
    options.isCancelled = [] { return true; };
    EXPECT_FALSE(SupportBuilder(options).build(layout));
}

} // namespace

} // namespace osgLego
