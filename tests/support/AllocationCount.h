#pragma once

#include <cstddef>

namespace osgLego::test
{

/** How often memory was allocated by operator new since the program started, by any thread and library of it. */
std::size_t countAllocations();

} // namespace osgLego::test
