#include "../layout/LaidModel.h"

#include <osgLego/search/Layout.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_group.h>

namespace osgLego
{

namespace
{

LayoutOptions withEffort(Effort effort, std::uint32_t seed = 0)
{
    LayoutOptions options;
    options.effort = effort;
    options.seed = seed;
    return options;
}

} // namespace

TEST(LayoutOptions, AnotherSeedGivesAnotherLayout)
{
    const LayoutProblem problem = makeDome(10, 1);
    EXPECT_EQ(layOut(problem, withEffort(Effort::INSTANT, 3)), layOut(problem, withEffort(Effort::INSTANT, 3)));
    EXPECT_NE(layOut(problem, withEffort(Effort::INSTANT, 3)), layOut(problem, withEffort(Effort::INSTANT, 4)));
}

TEST(LayoutOptions, MoreEffortGivesFewerPartsAndSeams)
{
    const LayoutProblem problem = makeDome(14, 14);
    const LaidParts quick = layOut(problem, withEffort(Effort::INSTANT));
    const LaidParts good = layOut(problem, withEffort(Effort::NORMAL));
    EXPECT_LT(good.size(), quick.size());
    EXPECT_LT(LaidModel(problem, good).countStackedSeams(), LaidModel(problem, quick).countStackedSeams());
}

TEST(LayoutOptions, ACancelledLayoutIsEmpty)
{
    const LayoutProblem problem = makeDome(12, 2);
    for (const int numCalls : {0, 1, 5, 50, 500})
    {
        std::atomic<int> calls = 0;
        LayoutOptions options;
        options.isCancelled = [&] { return calls++ >= numCalls; };
        EXPECT_TRUE(layOut(problem, options).empty()) << numCalls << " calls";
        EXPECT_LT(calls, numCalls + 100) << "the layout continued";
    }
}

TEST(LayoutOptions, ALayoutWhoseTasksAreCancelledBeginsNoOtherRound)
{
    const LayoutProblem problem = makeDome(12, 2);
    std::atomic<bool> isCancelled = false;
    oneapi::tbb::task_group group;
    int numRounds = 0;
    LayoutOptions options = withEffort(Effort::BEST);
    options.isCancelled = [&] { return isCancelled.load(); };
    options.progress = [&](double)
    {
        ++numRounds;
        isCancelled = true;
        group.cancel();
    };
    LaidParts parts;
    group.run_and_wait([&] { parts = layOut(problem, options); });
    EXPECT_EQ(numRounds, 1);
    EXPECT_TRUE(parts.empty());
}

TEST(LayoutOptions, ALayoutCancelledAtTheEndIsEmpty)
{
    const oneapi::tbb::global_control control(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    const LayoutProblem problem = makeDome(5, 2);
    int numCalls = 0;
    int last = -1;
    LayoutOptions options = withEffort(Effort::INSTANT);
    options.isCancelled = [&] { return numCalls++ == last; };
    EXPECT_FALSE(layOut(problem, options).empty());
    last = std::exchange(numCalls, 0) - 1;
    EXPECT_TRUE(layOut(problem, options).empty());
}

TEST(LayoutOptions, AnEffortHasAsManyRoundsAsTheNumberOfPartsAllows)
{
    // Cells of alternating colours are parts of their own. Each round reports its progress, and so does the end.
    const auto countRounds = [](int numCells, Effort effort)
    {
        LayoutOptions options = withEffort(effort);
        int numReports = 0;
        options.progress = [&](double) { ++numReports; };
        layOut(makeCells(
                   {numCells, 1, 1}, [](int x, int, int) { return x % 2; }, std::vector<LayoutColor>(2)),
               options);
        return numReports - 1;
    };
    EXPECT_EQ(countRounds(1, Effort::INSTANT), 3);
    EXPECT_EQ(countRounds(4100, Effort::INSTANT), 1);
    EXPECT_EQ(countRounds(4101, Effort::INSTANT), 0);
    EXPECT_EQ(countRounds(1, Effort::NORMAL), 40);
    EXPECT_EQ(countRounds(20000, Effort::NORMAL), 5);
    EXPECT_EQ(countRounds(60000, Effort::NORMAL), 2);
    EXPECT_EQ(countRounds(1, Effort::BEST), 250);
}

TEST(LayoutOptions, BestEffortLaysSmallSolidsSeveralTimes)
{
    // As above, but the last cell is interior and becomes a part together with the one beside it.
    const auto reportProgress = [](int numParts)
    {
        LayoutOptions options = withEffort(Effort::BEST);
        std::vector<double> reports;
        options.progress = [&](double done) { reports.push_back(done); };
        layOut(makeCells(
                   {numParts + 1, 1, 1}, [=](int x, int, int) { return x == numParts ? LayoutCell::ANY_COLOR : x % 2; },
                   std::vector<LayoutColor>(2)),
               options);
        EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end())) << numParts << " parts";
        EXPECT_EQ(reports.back(), 1.0) << numParts << " parts";
        return reports.size() - 1;
    };
    const std::size_t once = reportProgress(201);
    EXPECT_EQ(reportProgress(200), 2 * once);
    EXPECT_EQ(reportProgress(50), 8 * once);
    EXPECT_EQ(reportProgress(2), 8 * once);
}

TEST(LayoutOptions, MoreBondGivesFewerStackedSeams)
{
    const LayoutProblem problem = makeDome(9, 2);
    const auto countSeams = [&problem](int bond)
    {
        LayoutOptions options = withEffort(Effort::INSTANT);
        options.bond = bond;
        return LaidModel(problem, layOut(problem, options)).countStackedSeams();
    };
    EXPECT_LT(countSeams(10), countSeams(1));
}

TEST(LayoutOptions, ProgressIsReportedUpToOne)
{
    std::vector<double> fractions;
    LayoutOptions options;
    options.progress = [&](double fraction) { fractions.push_back(fraction); };
    layOut(makeDome(8, 1), options);
    ASSERT_GT(fractions.size(), 3u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_GT(fractions.front(), 0.0);
    EXPECT_EQ(fractions.back(), 1.0);
}

} // namespace osgLego
