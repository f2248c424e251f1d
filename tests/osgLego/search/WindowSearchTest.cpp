#include "LayoutRow.h"

#include <osgLego/layout/GreedyLayout.h>
#include <osgLego/search/LayoutCosts.h>
#include <osgLego/search/WindowSearch.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

namespace osgLego
{

namespace
{

constexpr int NUM_ROUNDS = 3;

/** Cells in patches of two colours, with some cells missing. */
LayoutProblem makeBlots(const glm::ivec3& size, bool isOfPlates)
{
    std::mt19937 random(3);
    LayoutProblem problem = makeCells(
        size, [&](int x, int y, int z) { return random() % 100 < 3 ? -1 : (x / 6 + y / 9 + z / 4) % 2; },
        std::vector<LayoutColor>(2));
    problem.isOfPlates = isOfPlates;
    return problem;
}

/** A greedy layout that is searched. */
struct SearchedMap : LaidMap
{
    explicit SearchedMap(const LayoutProblem& cells, std::uint32_t seed = 0) : LaidMap(cells)
    {
        options.seed = seed;
        layGreedily(map, sizes);
    }

    LayoutOptions options;
    const std::vector<bool> isActive;
    WindowSearch search{map, sizes, options, isActive};
};

/** The parts after some rounds in a number of threads. */
LaidParts improve(const LayoutProblem& problem, std::size_t numThreads, std::uint32_t seed = 0)
{
    const oneapi::tbb::global_control control(oneapi::tbb::global_control::max_allowed_parallelism, numThreads);
    SearchedMap searched(problem, seed);
    for (int round = 0; round < NUM_ROUNDS; ++round)
        EXPECT_TRUE(searched.search.runRound(LayoutCosts::HALF_SEAM, {2, 100}));
    return searched.getParts();
}

void expectTheSamePartsForAnyNumberOfThreads(const glm::ivec3& size, bool isOfPlates)
{
    const LayoutProblem problem = makeBlots(size, isOfPlates);
    const LaidParts parts = improve(problem, 1);
    EXPECT_EQ(LaidModel(problem, parts).findMistake(), "");
    EXPECT_NE(parts, SearchedMap(problem).getParts()) << "the rounds change nothing";
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
        SearchedMap searched(makeBlots({10, 480, 24}, isOfPlates));
        for (int round = 0; round < NUM_ROUNDS; ++round)
        {
            EXPECT_GT(expectSeparateRegions(searched.search), 0) << "no layer has several regions";
            searched.search.runRound(0, {1000, 1});
        }
    }
}

TEST(WindowSearch, BringsAllNeighboringLayersAndRowsTogetherInSomeRound)
{
    constexpr int NUM_LAYERS = 24;
    constexpr int NUM_ROWS = 300;
    for (const bool isOfPlates : {false, true})
    {
        SearchedMap searched(makeBlots({10, NUM_ROWS, NUM_LAYERS}, isOfPlates));
        std::set<int> layers;
        std::set<int> rows;
        for (int round = 0; round < 12; ++round)
        {
            for (const int phase : {0, 1, 2, 3})
                for (const LayoutRegion& region : searched.search.makeRegions(phase % 2, phase / 2))
                {
                    for (int z = region.zBegin; z + 1 < region.zEnd; ++z)
                        layers.insert(z);
                    for (int y = region.yBegin; y + 1 < region.yEnd; ++y)
                        rows.insert(y);
                }
            searched.search.runRound(0, {100000, 1});
        }
        EXPECT_EQ(layers.size(), NUM_LAYERS - 1u);
        EXPECT_EQ(rows.size(), NUM_ROWS - 1u);
    }
}

TEST(WindowSearch, BeginsWindowsAtPartsOfAllLayersAndRowsInEachRound)
{
    // Stripes of eight single cells, each of which may become one part.
    const LayoutProblem problem = makeCells(
        {16, 160, 10}, [](int x, int y, int z) { return x / 8 + 2 * (y % 2) + 4 * (z % 2); },
        std::vector<LayoutColor>(8));
    LaidMap laid(problem);
    for (CellLattice::Index cell = 0; cell < laid.lattice.getNumCells(); ++cell)
        laid.map.lay(cell, {});
    const LayoutOptions options;
    const std::vector<bool> isActive;
    WindowSearch search(laid.map, laid.sizes, options, isActive);
    ASSERT_GT(expectSeparateRegions(search), 0) << "no layer has several regions";
    search.runRound(0, {1, 100});
    EXPECT_LT(laid.map.countParts(), 2 * 160 * 10 * 11 / 10);
}

TEST(WindowSearch, ChangesNoPartThatBeginsAtAnInactiveCell)
{
    // Eight single cells may become one part.
    constexpr int LENGTH = 100;
    constexpr int NUM_ACTIVE = 24;
    constexpr LayoutColor ONLY_SINGLE_AND_LONGEST{0b100001, 0b100001};
    LayoutRow row(makeCells({LENGTH, 1, 1}, [](int, int, int) { return 0; }, {ONLY_SINGLE_AND_LONGEST}),
                  {std::vector<int>(LENGTH, 1)});
    const LayoutOptions options;
    std::vector<bool> isActive(LENGTH, false);
    std::fill_n(isActive.begin(), NUM_ACTIVE, true);
    WindowSearch search(row.map, row.sizes, options, isActive);
    for (int round = 0; round < 200; ++round)
        search.runRound(0, {1, 100000});
    const LaidParts parts = row.getParts();
    ASSERT_EQ(parts.size(), std::size_t(NUM_ACTIVE / 8 + LENGTH - NUM_ACTIVE));
    for (std::size_t i = NUM_ACTIVE / 8; i < parts.size(); ++i)
        EXPECT_EQ(parts[i].size[0], 1);
}

TEST(WindowSearch, SeparatesNoPartsThatOnlyPartsWhichMayChangeConnect)
{
    // Two parts of two cells would suffice in the upper layer, but only the one in the middle connects those below.
    LayoutRow row({{2, 2}, {1, 2, 1}});
    const LayoutOptions options;
    const std::vector<bool> isActive;
    WindowSearch search(row.map, row.sizes, options, isActive);
    for (int round = 0; round < 20; ++round)
        search.runRound(0, {1, 1000});
    EXPECT_EQ(row.map.countParts(), 5);
    EXPECT_EQ(row.countComponents(), 1);
}

TEST(WindowSearch, DependsOnTheSeed)
{
    const LayoutProblem problem = makeBlots({16, 16, 8}, false);
    EXPECT_EQ(improve(problem, 1, 3), improve(problem, 1, 3));
    EXPECT_NE(improve(problem, 1, 3), improve(problem, 1, 4));
}

} // namespace osgLego
