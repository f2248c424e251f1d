#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/model/SupportColumns.h>

#include <Layouts.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace osgLego
{

namespace
{

/** A post of three cells with an arm to the right on top. */
LayoutProblem drawGallows()
{
    return drawProblem({{"a....."}, {"a....."}, {"a....."}, {"aaaaaa"}});
}

const LaidParts GALLOWS{{{0, 0, 0}}, {{0, 0, 1}}, {{0, 0, 2}}, {{0, 0, 3}, {6, 1, 1}}};

TEST(SupportColumns, ReachFromTheGroundToThePart)
{
    const LayoutProblem problem = drawGallows();
    const std::vector<SupportColumn> columns = SupportColumns(problem, GALLOWS).find({3});
    ASSERT_FALSE(columns.empty());
    for (const SupportColumn& column : columns)
    {
        EXPECT_EQ(column.place.z, 0);
        EXPECT_EQ(column.height, 3);
        EXPECT_EQ(column.width, 1); // the grid has a single row
        EXPECT_GE(column.place.x, 1);
    }
    EXPECT_EQ(columns.front().place.x, 3) << "the middle comes first";
    const auto isOuter = [](const SupportColumn& column) { return column.place.x == 5; };
    EXPECT_TRUE(std::any_of(columns.begin(), columns.end(), isOuter));
}

TEST(SupportColumns, HaveTheColourOfThePartThatTheyHold)
{
    const LayoutProblem problem = drawProblem({{"a....."}, {"abbbbb"}});
    const LaidParts parts{{{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 1}, {5, 1, 1}, 1}};
    const std::vector<SupportColumn> columns = SupportColumns(problem, parts).find({2});
    ASSERT_FALSE(columns.empty());
    for (const SupportColumn& column : columns)
        EXPECT_EQ(column.color, 1);
}

TEST(SupportColumns, LeaveTheOtherPartsAndColumnsWhenTheyAreRemoved)
{
    const SupportedLayout bare{drawProblem({{"a.......", "........"}, {"aaaaaaaa", "aaaaaaaa"}}),
                               {{{0, 0, 0}}, {{0, 0, 1}, {8, 2, 1}}}};
    const SupportColumn left{{3, 0, 0}, 1, 1};
    const SupportColumn right{{6, 0, 0}, 2, 1};
    const SupportedLayout both = addColumns(bare, {left, right});
    ASSERT_EQ(findLayoutError(both.problem, both.parts), "");
    const SupportedLayout one = removeColumns(both, {&left, 1});
    EXPECT_EQ(findLayoutError(one.problem, one.parts), "");
    EXPECT_EQ(one.parts, addColumns(bare, {right}).parts);
    EXPECT_EQ(one.problem.cells.size(), bare.problem.cells.size() + 4);
    EXPECT_EQ(one.numColumnParts, 1u);
    ASSERT_EQ(one.columns.size(), 1u);
    EXPECT_EQ(one.columns.front().place, right.place);
    EXPECT_EQ(removeColumns(both, both.columns).parts, bare.parts);
}

TEST(SupportColumns, StandOnOthersWhoseTopTheyTouch)
{
    const SupportColumn wide{{2, 2, 0}, 2, 3};
    EXPECT_TRUE((SupportColumn{{3, 3, 3}, 1, 2}).standsOn(wide));
    EXPECT_TRUE((SupportColumn{{1, 1, 3}, 2, 1}).standsOn(wide));
    EXPECT_FALSE((SupportColumn{{3, 3, 4}, 1, 2}).standsOn(wide)) << "above it";
    EXPECT_FALSE((SupportColumn{{4, 3, 3}, 1, 2}).standsOn(wide)) << "beside it";
    EXPECT_FALSE((SupportColumn{{2, 0, 3}, 2, 1}).standsOn(wide)) << "before it";
    EXPECT_FALSE(wide.standsOn(wide));
}

TEST(SupportColumns, StandOnPartsBelow)
{
    const LayoutProblem problem = drawProblem({{"aaaa"}, {"a..."}, {"a..."}, {"aaaa"}});
    const LaidParts parts{{{0, 0, 0}, {4, 1, 1}}, {{0, 0, 1}}, {{0, 0, 2}}, {{0, 0, 3}, {4, 1, 1}}};
    for (const SupportColumn& column : SupportColumns(problem, parts).find({3}))
    {
        EXPECT_EQ(column.place.z, 1);
        EXPECT_EQ(column.height, 2);
    }
}

TEST(SupportColumns, HaveFourStudsWhereThereIsRoom)
{
    const LayoutProblem problem = drawProblem({{"a...", "a..."}, {"a...", "a..."}, {"aaaa", "aaaa"}});
    const LaidParts parts{{{0, 0, 0}, {1, 2, 1}}, {{0, 0, 1}, {1, 2, 1}}, {{0, 0, 2}, {4, 2, 1}}};
    const std::vector<SupportColumn> columns = SupportColumns(problem, parts).find({2});
    ASSERT_FALSE(columns.empty());
    for (const SupportColumn& column : columns)
        EXPECT_EQ(column.width, 2);
}

TEST(SupportColumns, HaveOneStudInColoursInWhichABrickOrAPlateOfFourStudsWasNeverMade)
{
    constexpr unsigned int FOUR_STUDS = 1u << 6; // 2x2 is the seventh size
    for (const bool isOfPlates : {false, true})
    {
        LayoutProblem problem = drawProblem({{"a...", "a..."}, {"a...", "a..."}, {"aaaa", "aaaa"}});
        LayoutColor& color = problem.colors[0];
        (isOfPlates ? color.plates : color.bricks) &= static_cast<std::uint16_t>(~FOUR_STUDS);
        const LaidParts parts{{{0, 0, 0}, {1, 2, 1}}, {{0, 0, 1}, {1, 2, 1}}, {{0, 0, 2}, {4, 2, 1}}};
        const std::vector<SupportColumn> columns = SupportColumns(problem, parts).find({2});
        ASSERT_FALSE(columns.empty());
        for (const SupportColumn& column : columns)
            EXPECT_EQ(column.width, 1) << (isOfPlates ? "plates" : "bricks");
    }
}

TEST(SupportColumns, AreNowhereBelowPartsThatRestOnOthers)
{
    const LayoutProblem problem = drawProblem({{"aaa"}, {"aaa"}});
    const LaidParts parts{{{0, 0, 0}, {3, 1, 1}}, {{0, 0, 1}, {3, 1, 1}}};
    EXPECT_TRUE(SupportColumns(problem, parts).find({0, 1}).empty());
}

TEST(SupportColumns, ConsistOfBricksAndOfPlatesWhereABrickIsTooHigh)
{
    const SupportColumn column{{5, 0, 0}, 1, 8, 0};
    EXPECT_EQ(buildColumn(column, false).size(), 8u);
    const LaidParts parts = buildColumn(column, true);
    ASSERT_EQ(parts.size(), 4u); // two bricks and two plates
    int height = 0;
    for (const LaidPart& part : parts)
    {
        EXPECT_EQ(part.place[2], height);
        height += part.size[2];
    }
    EXPECT_EQ(height, 8);
}

} // namespace

} // namespace osgLego
