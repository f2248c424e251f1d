#include <osgLego/layout/PossibleComponents.h>

#include "Layouts.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

/** Count components by comparing every part with every other. */
std::size_t countComponents(const LaidParts& parts)
{
    std::vector<std::size_t> labels(parts.size());
    std::iota(labels.begin(), labels.end(), std::size_t{0});
    const auto overlap = [](const LaidPart& a, const LaidPart& b, std::size_t axis)
    { return a.place[axis] < b.place[axis] + b.size[axis] && b.place[axis] < a.place[axis] + a.size[axis]; };
    for (std::size_t a = 0; a < parts.size(); ++a)
        for (std::size_t b = 0; b < parts.size(); ++b)
            if (parts[a].place[2] + 1 == parts[b].place[2] && overlap(parts[a], parts[b], 0) &&
                overlap(parts[a], parts[b], 1))
                std::replace(labels.begin(), labels.end(), std::size_t{labels[b]}, std::size_t{labels[a]});
    std::sort(labels.begin(), labels.end());
    return static_cast<std::size_t>(std::unique(labels.begin(), labels.end()) - labels.begin());
}

std::size_t findFewestComponents(const LayoutProblem& problem)
{
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    forEachLayout(problem, [&fewest](const LaidParts& parts) { fewest = std::min(fewest, countComponents(parts)); });
    return fewest;
}

TEST(PossibleComponents, NoLayoutHasFewer)
{
    for (unsigned int seed = 0; seed < 60; ++seed)
    {
        LayoutProblem problem = createRandomProblem({3, 2, 2}, "aaab*.", seed);
        if (seed % 3 == 0) problem.colors[0].bricks = 0x5; // only 1x1 and 1x3
        EXPECT_LE(countPossibleComponents(problem), findFewestComponents(problem)) << seed;
    }
}

TEST(PossibleComponents, NearlyAlwaysALayoutHasAsFewIfCellsSuitEachOther)
{
    unsigned int numEqual = 0;
    for (unsigned int seed = 0; seed < 60; ++seed)
    {
        const LayoutProblem problem = createRandomProblem({3, 2, 2}, "aaa*.", seed);
        numEqual += countPossibleComponents(problem) == findFewestComponents(problem) ? 1u : 0u;
    }
    EXPECT_GE(numEqual, 50u);
}

TEST(PossibleComponents, PartsOfOneLayerAreNotConnected)
{
    EXPECT_EQ(countPossibleComponents(drawProblem({{std::string(8, 'a')}})), 1u);
    EXPECT_EQ(countPossibleComponents(drawProblem({{std::string(17, 'a')}})), 3u);
    EXPECT_EQ(countPossibleComponents(drawProblem({{"abc", "bca", "cab"}})), 9u);
}

TEST(PossibleComponents, ABridgeIsNoLongerThanAPart)
{
    EXPECT_EQ(countPossibleComponents(drawProblem({{"a......a"}, {"aaaaaaaa"}})), 1u);
    // Both ends can be in parts that reach into the bridge, but no part reaches across it.
    EXPECT_EQ(countPossibleComponents(drawProblem({{"a.......a"}, {"aaaaaaaaa"}})), 2u);
    // 22 cells in the middle: seven from each end reach a column, the others are one part at least.
    const std::string ends = "a" + std::string(22, '.') + "a";
    EXPECT_EQ(countPossibleComponents(drawProblem({{ends}, {std::string(24, 'a')}})), 3u);
}

TEST(PossibleComponents, AColourThatExistsOnlyIn1x1ConnectsNothing)
{
    LayoutProblem problem = drawProblem({{"aa"}, {"aa"}});
    EXPECT_EQ(countPossibleComponents(problem), 1u);
    problem.colors[0].bricks = 1;
    EXPECT_EQ(countPossibleComponents(problem), 2u);
    problem.colors[0].bricks = 5; // no 1x2, but 1x3
    EXPECT_EQ(countPossibleComponents(problem), 2u);
    problem = drawProblem({{"aaa"}, {"aaa"}});
    problem.colors[0].bricks = 5;
    EXPECT_EQ(countPossibleComponents(problem), 1u);
    problem = drawProblem({{"ab"}, {"ab"}});
    EXPECT_EQ(countPossibleComponents(problem), 2u);
    problem = drawProblem({{"ab"}, {"a*"}});
    EXPECT_EQ(countPossibleComponents(problem), 1u);
}

TEST(PossibleComponents, BricksConnectColumnsOfPlates)
{
    LayoutProblem problem = drawProblem({{"aa"}, {"aa"}, {"aa"}});
    problem.isOfPlates = true;
    problem.colors[0] = {0x7ff, 1};
    EXPECT_EQ(countPossibleComponents(problem), 1u);
    problem.colors[0] = {1, 1};
    EXPECT_EQ(countPossibleComponents(problem), 2u);
}

TEST(PossibleComponents, OverhangsOfPlatesAreOfPlates)
{
    LayoutProblem problem = drawProblem({{"aa"}, {"a."}});
    problem.isOfPlates = true;
    problem.colors[0] = {0x7ff, 1};
    EXPECT_EQ(countPossibleComponents(problem), 2u);
    problem.colors[0] = {1, 0x7ff};
    EXPECT_EQ(countPossibleComponents(problem), 1u);
}

TEST(PossibleComponents, HaveANumberForCellsAboveEachOtherOnly)
{
    using Numbers = std::vector<std::int32_t>;
    EXPECT_EQ(findPossibleComponents(drawProblem({{"aa...a"}, {"a....a"}})), (Numbers{0, NO_COMPONENT, 2, 0, 2}));
    EXPECT_EQ(findPossibleComponents(drawProblem({{"aab"}, {"aab"}})), (Numbers{0, 0, 2, 0, 0, 2}));
}

} // namespace

} // namespace osgLego
