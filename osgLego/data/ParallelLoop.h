#pragma once

#include <cstddef>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

namespace osgLego
{

/** Call `function(index)` for each index from 0 to `count` - 1, from several threads at once. Every call is made, even
 * if the caller is a task whose group is cancelled meanwhile: a loop of oneTBB would skip the rest without a word, and
 * tables that others use later would stay incomplete. */
template <typename Function>
void forEachIndex(std::size_t count, const Function& function)
{
    oneapi::tbb::task_group_context context(oneapi::tbb::task_group_context::isolated);
    // Isolated: while it waits here, the thread must not run tasks of the caller, which may need locks that it holds.
    oneapi::tbb::this_task_arena::isolate([&] { oneapi::tbb::parallel_for(std::size_t(0), count, function, context); });
}

} // namespace osgLego
