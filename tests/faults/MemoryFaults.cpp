#include "MemoryFaults.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <new>
#include <set>
#include <span>
#include <utility>

#include <execinfo.h>

namespace
{

using osgLego::test::MemoryFaults;

constexpr std::size_t NEVER = std::numeric_limits<std::size_t>::max();

std::atomic<std::size_t> numCalls{0}; // since begin() or record()
std::atomic<std::size_t> firstFault{NEVER};
std::atomic<std::size_t> lastFault{NEVER};
std::atomic<std::size_t> numFaults{0};
std::atomic<std::size_t> numBlocks{0};

/** The calls of different call stacks. */
class CallStacks
{
public:
    std::vector<std::size_t> take()
    {
        const std::lock_guard lock(_mutex);
        _hashes.clear();
        return std::exchange(_calls, {});
    }

    void note(std::size_t call)
    {
        std::array<void*, 12> frames{};
        const int depth = backtrace(frames.data(), static_cast<int>(frames.size()));
        std::uint64_t hash = 14695981039346656037u; // FNV-1a
        for (void* frame : std::span(frames).first(static_cast<std::size_t>(depth)))
            hash = (hash ^ reinterpret_cast<std::uintptr_t>(frame)) * 1099511628211u;
        const std::lock_guard lock(_mutex);
        if (_hashes.insert(hash).second) _calls.push_back(call);
    }

private:
    std::mutex _mutex;
    std::set<std::uint64_t> _hashes;
    std::vector<std::size_t> _calls;
};

std::atomic<bool> isRecording{false};

CallStacks& getCallStacks()
{
    static CallStacks stacks;
    return stacks;
}

/** Count a call that is to return a block. */
void countCall()
{
    // Calls of operator new that recording makes itself are not counted.
    thread_local bool isNoting = false;
    if (isNoting) return;
    const std::size_t call = numCalls.fetch_add(1, std::memory_order_relaxed);
    if (isRecording)
    {
        isNoting = true;
        getCallStacks().note(call);
        isNoting = false;
    }
    if (call < firstFault || call > lastFault) return;
    ++numFaults;
    throw std::bad_alloc();
}

void* count(void* memory)
{
    if (!memory) throw std::bad_alloc();
    ++numBlocks;
    return memory;
}

void release(void* memory)
{
    if (!memory) return;
    --numBlocks;
    std::free(memory);
}

} // namespace

// These operators replace those of the standard library in the whole program; the other forms call them.
void* operator new(std::size_t size)
{
    countCall();
    return count(std::malloc(std::max<std::size_t>(size, 1)));
}

void* operator new(std::size_t size, std::align_val_t alignment)
{
    countCall();
    const auto step = static_cast<std::size_t>(alignment);
    return count(std::aligned_alloc(step, (std::max<std::size_t>(size, 1) + step - 1) / step * step));
}

void operator delete(void* memory) noexcept
{
    release(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    release(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
    release(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    release(memory);
}

namespace osgLego::test
{

void MemoryFaults::begin(std::size_t first, Extent extent)
{
    numCalls = 0;
    numFaults = 0;
    lastFault = extent == Extent::ONE ? first : NEVER;
    firstFault = first;
}

bool MemoryFaults::end()
{
    firstFault = NEVER;
    return numFaults > 0;
}

void MemoryFaults::record()
{
    getCallStacks().take();
    numCalls = 0;
    isRecording = true;
}

std::vector<std::size_t> MemoryFaults::getRecorded()
{
    isRecording = false;
    return getCallStacks().take();
}

std::size_t MemoryFaults::getNumBlocks()
{
    return numBlocks;
}

} // namespace osgLego::test
