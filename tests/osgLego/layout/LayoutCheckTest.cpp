#include <osgLego/layout/LayoutCheck.h>

#include "Layouts.h"

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(LayoutCheck, AcceptsPartsThatCoverEveryCellOnceInItsColour)
{
    const LayoutProblem problem = drawProblem({{"aab", "a*b"}, {"..b"}});
    EXPECT_EQ(
        findLayoutError(problem, {{{0, 0, 0}, {2, 2, 1}, 0}, {{2, 0, 0}, {1, 2, 1}, 1}, {{2, 0, 1}, {1, 1, 1}, 1}}),
        "");
}

TEST(LayoutCheck, NamesTheFirstErrorOfALayout)
{
    const LayoutProblem problem = drawProblem({{"aab", "aa."}});
    EXPECT_EQ(findLayoutError(problem, {{{0, 0, 0}, {2, 2, 1}, 0}}), "no part covers the cell 2 0 0");
    EXPECT_EQ(findLayoutError(problem, {{{0, 0, 0}, {2, 2, 1}, 0}, {{1, 0, 0}, {1, 1, 1}, 0}}),
              "two parts cover the cell 1 0 0");
    EXPECT_EQ(findLayoutError(problem, {{{1, 0, 0}, {2, 1, 1}, 0}}),
              "the part that covers the cell 2 0 0 has another colour");
    EXPECT_EQ(findLayoutError(problem, {{{2, 0, 0}, {1, 2, 1}, 1}}), "a part covers 2 1 0, not a cell");
    EXPECT_EQ(findLayoutError(problem, {{{0, 0, 0}, {2, 2, 1}, 2}}),
              "the part at 0 0 0 has a colour that does not exist");
}

TEST(LayoutCheck, RefusesSizesThatDoNotExist)
{
    const LayoutProblem row = drawProblem({{"aaaaa"}});
    EXPECT_EQ(findLayoutError(row, {{{0, 0, 0}, {5, 1, 1}, 0}}), "the part at 0 0 0 has a size that does not exist");
    LayoutProblem column = drawProblem({{"a"}, {"a"}, {"a"}});
    EXPECT_NE(findLayoutError(column, {{{0, 0, 0}, {1, 1, 3}, 0}}), "");
    column.isOfPlates = true;
    EXPECT_EQ(findLayoutError(column, {{{0, 0, 0}, {1, 1, 3}, 0}}), "");
    EXPECT_NE(findLayoutError(column, {{{0, 0, 0}, {1, 1, 2}, 0}, {{0, 0, 2}, {1, 1, 1}, 0}}), "");
}

TEST(LayoutCheck, APlateIsAvailableWhereItsBrickIsNot)
{
    LayoutProblem problem = drawProblem({{"ab"}, {"aa"}, {"aa"}});
    problem.isOfPlates = true;
    problem.colors[0] = {0x7fd, 0x7ff}; // no brick 1x2
    EXPECT_TRUE(isAvailable(problem, {{0, 0, 1}, {2, 1, 1}, 0}));
    EXPECT_FALSE(isAvailable(problem, {{0, 0, 0}, {2, 1, 3}, 0}));
    EXPECT_TRUE(isAvailable(problem, {{0, 0, 0}, {2, 1, 3}, 1}));
    problem.isOfPlates = false;
    EXPECT_FALSE(isAvailable(problem, {{0, 0, 1}, {2, 1, 1}, 0}));
}

} // namespace

} // namespace osgLego
