#include <osgLego/layout/LayoutFigures.h>

#include "Layouts.h"

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

TEST(LayoutFigures, PartsAreConnectedOnlyIfOneLiesOnTheOther)
{
    // Two columns side by side, of two parts each, and above a gap a part that nothing carries.
    const LayoutProblem problem = drawProblem({{"aa"}, {"aa"}, {".."}, {".a"}});
    const LayoutFigures figures = computeLayoutFigures(problem, {{{0, 0, 0}, {1, 1, 1}, 0},
                                                                 {{1, 0, 0}, {1, 1, 1}, 0},
                                                                 {{0, 0, 1}, {1, 1, 1}, 0},
                                                                 {{1, 0, 1}, {1, 1, 1}, 0},
                                                                 {{1, 0, 3}, {1, 1, 1}, 0}});
    EXPECT_EQ(figures.cells, 5u);
    EXPECT_EQ(figures.parts, 5u);
    EXPECT_EQ(figures.components, 3u);
    EXPECT_EQ(figures.componentsPossible, 2u);
    EXPECT_EQ(figures.floating, 1u);
    EXPECT_EQ(figures.articulationParts, 0u);
}

TEST(LayoutFigures, CountsJointsThatLieOnJoints)
{
    // Above the joint between x = 1 and 2 are a joint and then a part; beside them is a joint that lies on a part.
    const LayoutProblem problem = drawProblem({{"aaaa"}, {"aaaa"}, {"aaaa"}});
    const LayoutFigures figures = computeLayoutFigures(problem, {{{0, 0, 0}, {2, 1, 1}, 0},
                                                                 {{2, 0, 0}, {2, 1, 1}, 0},
                                                                 {{0, 0, 1}, {2, 1, 1}, 0},
                                                                 {{2, 0, 1}, {2, 1, 1}, 0},
                                                                 {{0, 0, 2}, {3, 1, 1}, 0},
                                                                 {{3, 0, 2}, {1, 1, 1}, 0}});
    EXPECT_EQ(figures.joints, 3u);
    EXPECT_EQ(figures.stackedLength, 1u);
    EXPECT_DOUBLE_EQ(figures.getStackedSeams(), 1.0 / 3.0);
    EXPECT_EQ(figures.components, 1u);
}

TEST(LayoutFigures, AJointIsAsLongAsTheCellsBesideIt)
{
    const LayoutProblem problem = drawProblem({{"aaaa", "aaaa"}, {"aaaa", "aaaa"}});
    const LaidParts parts{
        {{0, 0, 0}, {2, 2, 1}, 0}, {{2, 0, 0}, {2, 2, 1}, 0}, {{0, 0, 1}, {4, 1, 1}, 0}, {{0, 1, 1}, {4, 1, 1}, 0}};
    const LayoutFigures figures = computeLayoutFigures(problem, parts);
    EXPECT_EQ(figures.joints, 2u + 4u);
    EXPECT_EQ(figures.stackedLength, 0u);
}

TEST(LayoutFigures, CountsJointsThatColoursForceUponEachOther)
{
    // A border above a border, beside a cell of any colour, and above a gap.
    const LayoutProblem problem = drawProblem({{"ab*"}, {"aba"}, {"..."}, {"ab."}});
    LaidParts parts;
    for (const LayoutCell& cell : problem.cells)
        parts.push_back({cell.place, {1, 1, 1}, cell.color == LayoutCell::ANY_COLOR ? std::uint16_t{0} : cell.color});
    const LayoutFigures figures = computeLayoutFigures(problem, parts);
    EXPECT_EQ(figures.joints, 5u);
    EXPECT_EQ(figures.stackedLength, 2u);
    EXPECT_EQ(figures.stackedBorders, 1u);
    EXPECT_DOUBLE_EQ(figures.getStackedBorders(), 0.2);
}

TEST(LayoutFigures, ABrickBesidePlatesHasNoStackedJoint)
{
    LayoutProblem problem = drawProblem({{"aa"}, {"aa"}, {"aa"}, {"aa"}});
    problem.isOfPlates = true;
    const LaidPart lower{{0, 0, 0}, {1, 1, 3}, 0};
    const LaidPart upper{{0, 0, 3}, {1, 1, 1}, 0};
    LayoutFigures figures = computeLayoutFigures(problem, {lower,
                                                           {{1, 0, 0}, {1, 1, 1}, 0},
                                                           {{1, 0, 1}, {1, 1, 1}, 0},
                                                           {{1, 0, 2}, {1, 1, 1}, 0},
                                                           upper,
                                                           {{1, 0, 3}, {1, 1, 1}, 0}});
    EXPECT_EQ(figures.joints, 4u);
    EXPECT_EQ(figures.stackedLength, 1u);
    EXPECT_EQ(figures.components, 2u);
    EXPECT_EQ(figures.articulationParts, 2u);

    // A joint between two bricks, three plates high, counts once.
    figures = computeLayoutFigures(problem, {lower, {{1, 0, 0}, {1, 1, 3}, 0}, upper, {{1, 0, 3}, {1, 1, 1}, 0}});
    EXPECT_EQ(figures.joints, 2u);
    EXPECT_EQ(figures.stackedLength, 1u);
}

TEST(LayoutFigures, FindsPartsThatHoldTheOthersTogether)
{
    // A bridge holds two piers; the lower part of each pier holds nothing else.
    const LayoutProblem problem = drawProblem({{"a..a"}, {"a..a"}, {"aaaa"}});
    const LayoutFigures figures = computeLayoutFigures(problem, {{{0, 0, 0}, {1, 1, 1}, 0},
                                                                 {{3, 0, 0}, {1, 1, 1}, 0},
                                                                 {{0, 0, 1}, {1, 1, 1}, 0},
                                                                 {{3, 0, 1}, {1, 1, 1}, 0},
                                                                 {{0, 0, 2}, {4, 1, 1}, 0}});
    EXPECT_EQ(figures.components, 1u);
    EXPECT_EQ(figures.articulationParts, 3u);
    EXPECT_EQ(figures.floating, 0u);
}

TEST(LayoutFigures, CountsColoursAndPartsThatWereNeverMade)
{
    LayoutProblem problem = drawProblem({{"aab*"}});
    problem.colors[0].bricks = 0x7fd; // no 1x2
    const LayoutFigures figures = computeLayoutFigures(problem, {{{0, 0, 0}, {2, 1, 1}, 0}, {{2, 0, 0}, {2, 1, 1}, 1}});
    EXPECT_EQ(figures.colors, 2u);
    EXPECT_EQ(figures.unavailable, 1u);
}

TEST(LayoutFigures, OfNoCellsAreZero)
{
    LayoutProblem problem;
    problem.colors.resize(1);
    const LayoutFigures figures = computeLayoutFigures(problem, {});
    EXPECT_EQ(figures.parts, 0u);
    EXPECT_EQ(figures.components, 0u);
    EXPECT_EQ(figures.componentsPossible, 0u);
    EXPECT_EQ(figures.getStackedSeams(), 0.0);
}

} // namespace

} // namespace osgLego
