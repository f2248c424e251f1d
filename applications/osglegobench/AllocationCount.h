#pragma once

#include <cstddef>

namespace osgLego
{

/** Allocations by operator new in the whole program, its libraries included, since it started. Memory that C libraries
 * and drivers allocate by other means is not counted. */
struct AllocationCount
{
    static std::size_t getNumAllocations();
    /** The bytes of the largest block ever allocated. */
    static std::size_t getLargestBlock();
};

} // namespace osgLego
