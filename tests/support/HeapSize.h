#pragma once

#include <cstddef>

#include <malloc.h>

namespace osgLego::test
{

/** The bytes that the program has allocated and not freed; 0 with a sanitizer, which replaces malloc(). */
inline std::size_t getHeapSize()
{
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

/** The most that a test allows for a few bricks, wherever they are in the largest grid: less than a bit for each of its
 * cells, and more than SparseBox takes for its pages. */
inline constexpr std::size_t HEAP_OF_FEW_BRICKS = std::size_t(16) << 20;

} // namespace osgLego::test
