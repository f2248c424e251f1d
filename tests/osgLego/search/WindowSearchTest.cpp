#include "../layout/LaidModel.h"

#include <osgLego/layout/GreedyLayout.h>
#include <osgLego/layout/PartColors.h>
#include <osgLego/search/LayoutCosts.h>
#include <osgLego/search/WindowSearch.h>

#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

namespace osgLego
{

namespace
{

constexpr int NUM_ROUNDS = 3;

/** Cells of two colours in blots, with some cells missing. */
LayoutProblem makeBlots(const glm::ivec3& size, bool isOfPlates)
{
    std::mt19937 random(3);
    LayoutProblem problem = makeCells(
        size, [&](int x, int y, int z) { return random() % 100 < 3 ? -1 : (x / 6 + y / 9 + z / 4) % 2; },
        std::vector<LayoutColor>(2));
    problem.isOfPlates = isOfPlates;
    return problem;
}

/** The parts after some rounds in a number of threads. */
LaidParts improve(const LayoutProblem& problem, std::size_t numThreads)
{
    const oneapi::tbb::global_control control(oneapi::tbb::global_control::max_allowed_parallelism, numThreads);
    const CellLattice lattice(problem);
    const PartSizes sizes(problem);
    PartMap map(lattice);
    layGreedily(map, sizes);
    const LayoutOptions options;
    const std::vector<bool> isActive;
    WindowSearch search(map, sizes, options, isActive);
    for (int round = 0; round < NUM_ROUNDS; ++round)
        EXPECT_TRUE(search.runRound(LayoutCosts::HALF_SEAM, {2, 100}));
    return collectParts(map, sizes);
}

LaidParts layGreedily(const LayoutProblem& problem)
{
    const CellLattice lattice(problem);
    const PartSizes sizes(problem);
    PartMap map(lattice);
    layGreedily(map, sizes);
    return collectParts(map, sizes);
}

void expectTheSamePartsForAnyNumberOfThreads(const glm::ivec3& size, bool isOfPlates)
{
    const LayoutProblem problem = makeBlots(size, isOfPlates);
    const LaidParts parts = improve(problem, 1);
    EXPECT_EQ(LaidModel(problem, parts).findMistake(), "");
    EXPECT_NE(parts, layGreedily(problem)) << "the rounds change nothing";
    for (const std::size_t numThreads : {2, 4, 8})
    {
        const LaidParts others = improve(problem, numThreads);
        EXPECT_TRUE(others == parts) << numThreads << " threads";
    }
}

/** Whether a region is so far from another that it reads no part that may change there. */
bool isSeparate(const LayoutRegion& region, const LayoutRegion& other)
{
    const auto isApart = [](int begin, int end, int otherBegin, int otherEnd, int margin)
    { return otherBegin >= end + margin || otherEnd <= begin - margin; };
    return isApart(region.zBegin, region.zEnd, other.zBegin, other.zEnd, region.zMargin) ||
           isApart(region.yBegin, region.yEnd, other.yBegin, other.yEnd, region.yMargin);
}

/** Expect separate regions in every phase. @return the number of pairs of regions that rows separate. */
int expectSeparateRegions(const WindowSearch& search)
{
    int numBands = 0;
    for (const int phase : {0, 1, 2, 3})
    {
        const std::vector<LayoutRegion> regions = search.makeRegions(phase % 2, phase / 2);
        for (std::size_t i = 0; i < regions.size(); ++i)
            for (std::size_t j = 0; j < regions.size(); ++j)
            {
                if (i == j) continue;
                EXPECT_TRUE(isSeparate(regions[i], regions[j])) << phase << ": " << i << ", " << j;
                numBands += regions[i].zBegin == regions[j].zBegin ? 1 : 0;
            }
    }
    return numBands;
}

} // namespace

TEST(WindowSearch, OfManyLayersDoesNotDependOnTheNumberOfThreads)
{
    for (const bool isOfPlates : {false, true})
        expectTheSamePartsForAnyNumberOfThreads({16, 16, 96}, isOfPlates);
}

TEST(WindowSearch, OfBandsInLargeLayersDoesNotDependOnTheNumberOfThreads)
{
    for (const bool isOfPlates : {false, true})
        expectTheSamePartsForAnyNumberOfThreads({10, 480, 8}, isOfPlates);
}

TEST(WindowSearch, WorksOnRegionsAtTheSameTimeThatOthersSeparate)
{
    for (const bool isOfPlates : {false, true})
    {
        const LayoutProblem problem = makeBlots({10, 480, 24}, isOfPlates);
        const CellLattice lattice(problem);
        const PartSizes sizes(problem);
        PartMap map(lattice);
        layGreedily(map, sizes);
        const LayoutOptions options;
        const std::vector<bool> isActive;
        WindowSearch search(map, sizes, options, isActive);
        for (int round = 0; round < NUM_ROUNDS; ++round)
        {
            EXPECT_GT(expectSeparateRegions(search), 0) << "no layer has several regions";
            search.runRound(0, {1000, 1});
        }
    }
}

} // namespace osgLego
