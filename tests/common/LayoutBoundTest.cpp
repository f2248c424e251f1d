#include <common/LayoutBound.h>

#include "Layouts.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace osgLego
{

namespace
{

std::size_t boundLayer(const LayoutProblem& problem)
{
    const std::vector<LayerBound> bounds = boundLayers(problem, {}, {});
    EXPECT_EQ(bounds.size(), 1u);
    EXPECT_TRUE(bounds.front().isOptimum);
    return bounds.front().parts;
}

std::size_t findFewestParts(const LayoutProblem& problem)
{
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    forEachLayout(problem, [&fewest](const LaidParts& parts) { fewest = std::min(fewest, parts.size()); });
    return fewest;
}

TEST(LayoutBound, OfSmallLayersIsTheOptimum)
{
    EXPECT_EQ(boundLayer(drawProblem({{"aaaaaaaa", "aaaaaaaa"}})), 1u);
    EXPECT_EQ(boundLayer(drawProblem({{"aaaaa"}})), 2u);
    EXPECT_EQ(boundLayer(drawProblem({{"aaa", "aaa", "aaa"}})), 2u);
    EXPECT_EQ(boundLayer(drawProblem({{"aaa", "a..", "a.."}})), 2u);
    EXPECT_EQ(boundLayer(drawProblem({{"aaa", "a.a", "aaa"}})), 4u);
    EXPECT_EQ(boundLayer(drawProblem({{"a.a", ".a.", "a.a"}})), 5u);
}

TEST(LayoutBound, AgreesWithBruteForce)
{
    for (unsigned int seed = 0; seed < 40; ++seed)
    {
        LayoutProblem problem = createRandomProblem({4, 3, 1}, seed % 2 == 0 ? "aaaab*." : "aaaaaa.", seed);
        if (seed % 3 == 0) problem.colors[0].bricks = 0x4d; // no 1x2, no 1x6 and longer
        EXPECT_EQ(boundLayer(problem), findFewestParts(problem)) << seed;
    }
}

TEST(LayoutBound, PartsOfTwoColoursMeetInCellsOfAnyColour)
{
    EXPECT_EQ(boundLayer(drawProblem({{"ab"}})), 2u);
    EXPECT_EQ(boundLayer(drawProblem({{"a**b"}})), 2u);
    EXPECT_EQ(boundLayer(drawProblem({{"****"}})), 1u);
}

TEST(LayoutBound, CountsACellThatNoPartCanCover)
{
    LayoutProblem problem = drawProblem({{"aaa"}});
    problem.colors[0].bricks = 2; // only 1x2
    EXPECT_EQ(boundLayer(problem), 2u);
}

// Half of each of many 1x3s is a solution of the linear program here, and nearly a part better than any layout.
TEST(LayoutBound, IsTheOptimumWhereTheLinearProgramHasLess)
{
    for (const unsigned int seed : {0u, 10u})
    {
        LayoutProblem problem = createRandomProblem({5, 5, 1}, "aaaaaaaa.", seed);
        problem.colors[0].bricks = 0x5; // 1x1 and 1x3
        EXPECT_EQ(boundLayer(problem), findFewestParts(problem)) << seed;
    }
}

TEST(LayoutBound, IsComputedForTheLayersThatAreAskedFor)
{
    const LayoutProblem problem = drawProblem({{"aaaaa"}, {"aa.aa"}, {"....."}, {"aaaa"}, {"aaaaa"}});
    const std::vector<LayerBound> some = boundLayers(problem, {4, 1, 2}, {});
    EXPECT_EQ(some, (std::vector<LayerBound>{{4, 2, true}, {1, 2, true}, {2, 0, true}}));
    const std::vector<LayerBound> all = boundLayers(problem, {}, {});
    EXPECT_EQ(all, (std::vector<LayerBound>{{0, 2, true}, {1, 2, true}, {3, 1, true}, {4, 2, true}}));
}

TEST(LayoutBound, WithoutTimeIsNoOptimumButABound)
{
    LayoutProblem problem = createRandomProblem({30, 30, 1}, "aaaaaaaaaaaa.", 7);
    BoundOptions options;
    options.seconds = 0.0;
    const std::vector<LayerBound> bounds = boundLayers(problem, {}, options);
    ASSERT_EQ(bounds.size(), 1u);
    EXPECT_FALSE(bounds.front().isOptimum);
    EXPECT_GE(bounds.front().parts, problem.cells.size() / 16);
    EXPECT_LE(bounds.front().parts, problem.cells.size() / 2);
}

TEST(LayoutBound, IsEmptyIfCancelled)
{
    BoundOptions options;
    options.isCancelled = [] { return true; };
    EXPECT_TRUE(boundLayers(drawProblem({{"aaaaa"}}), {}, options).empty());
}

} // namespace

} // namespace osgLego
