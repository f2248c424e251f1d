#include "AllocationCount.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace
{

std::atomic<std::size_t> numAllocations{0};
std::atomic<std::size_t> largestBlock{0};

void note(std::size_t size)
{
    numAllocations.fetch_add(1, std::memory_order_relaxed);
    std::size_t largest = largestBlock.load(std::memory_order_relaxed);
    while (size > largest && !largestBlock.compare_exchange_weak(largest, size, std::memory_order_relaxed))
        ;
}

} // namespace

// These operators replace those of the standard library in the whole program; the other forms call them.
void* operator new(std::size_t size)
{
    note(size);
    if (void* memory = std::malloc(std::max<std::size_t>(size, 1))) return memory;
    throw std::bad_alloc();
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    note(size);
    const auto step = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(step, (std::max<std::size_t>(size, 1) + step - 1) / step * step))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    std::free(memory);
}

namespace osgLego
{

std::size_t AllocationCount::getNumAllocations()
{
    return numAllocations.load(std::memory_order_relaxed);
}

std::size_t AllocationCount::getLargestBlock()
{
    return largestBlock.load(std::memory_order_relaxed);
}

} // namespace osgLego
