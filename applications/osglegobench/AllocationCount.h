#pragma once

#include <cstddef>

namespace osgLego
{

/** What was allocated by operator new since the program started, in all of it, its libraries included.
 *
 * What C libraries and drivers allocate by themselves has no part in it. */
struct AllocationCount
{
    std::size_t ofAllThreads = 0;
    std::size_t ofThisThread = 0;

    static AllocationCount now();
    /** The bytes of the largest block that was ever allocated. */
    static std::size_t findLargestBlock();
};

} // namespace osgLego
