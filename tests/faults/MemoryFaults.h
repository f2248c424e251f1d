#pragma once

#include <cstddef>
#include <vector>

namespace osgLego::test
{

/** Lets operator new of the whole program fail, in every thread. */
class MemoryFaults
{
public:
    /** Which calls fail. */
    enum class Extent
    {
        ONE,      //!< only the chosen one
        ALL_AFTER //!< the chosen one, and all after it
    };

    /** From now on, let calls fail. @param first the number of the chosen call, from 0 on. */
    static void begin(std::size_t first, Extent extent);
    /** Let no more calls fail. @return whether one has failed since begin(). */
    static bool end();

    /** From now on, record the calls. */
    static void record();
    /** @return of the calls since record(), the first one of each call stack, as numbers for begin(). */
    static std::vector<std::size_t> getRecorded();

    /** The number of blocks that operator new has returned and operator delete has not freed. */
    static std::size_t getNumBlocks();
};

} // namespace osgLego::test
