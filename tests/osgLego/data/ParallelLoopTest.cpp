#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>
#include <oneapi/tbb/task_group.h>

namespace osgLego
{

namespace
{

TEST(ParallelLoop, CallsTheFunctionOnceForEachIndex)
{
    std::vector<std::atomic<int>> calls(1000);
    forEachIndex(calls.size(), [&](std::size_t index) { ++calls[index]; });
    EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](const std::atomic<int>& count) { return count == 1; }));
    forEachIndex(0, [](std::size_t) { FAIL(); });
}

TEST(ParallelLoop, IsCompleteEvenIfTheTaskThatRunsItIsCancelled)
{
    oneapi::tbb::task_group group;
    std::atomic<int> calls = 0;
    group.run_and_wait(
        [&]
        {
            group.cancel();
            forEachIndex(1000, [&](std::size_t) { ++calls; });
        });
    EXPECT_EQ(calls, 1000);
}

} // namespace

} // namespace osgLego
