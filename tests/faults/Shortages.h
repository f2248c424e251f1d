#pragma once

#include "MemoryFaults.h"

#include <functional>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

namespace osgLego::test
{

/** Work for which memory may end anywhere. */
struct Work
{
    /** Whether a lack of memory may be reported by std::bad_alloc, as the documentation of the function says. */
    bool mayThrow = false;
    std::function<void()> prepare = [] {}; //!< called before, while there is memory
    std::function<void()> work;
    /** The result, in any text form, called while there is memory; empty if the work has failed, without exception. */
    std::function<std::string()> getResult;
    std::function<std::string()> getMessage = [] { return std::string(); }; //!< apart from printed ones
};

/** Whether one allocation fails or all from then on, and the number of threads of oneTBB. */
using Scarcity = std::tuple<MemoryFaults::Extent, int>;

/** The name of a scarcity in the name of a test. */
std::string nameOf(const ::testing::TestParamInfo<Scarcity>& scarcity);

/** Do work without faults, and then with each allocation that has a call stack of its own failing. The test fails if
 * the work ends in another way than with the same result, a message that names memory or, if that is allowed,
 * std::bad_alloc, if it does not succeed afterwards, or if blocks are lost. */
void surviveShortages(const Work& work, const Scarcity& scarcity);

} // namespace osgLego::test
