#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>

#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

namespace osgLego
{

/** Do work that may throw.
 * @param outOfMemory the sentence for a lack of memory. @param prefix comes before the reason of any other failure.
 * @return the reason why the work failed; empty if it did not. */
inline std::string catchFailure(const std::function<void()>& work, const char* outOfMemory, const char* prefix = "")
{
    try
    {
        work();
        return {};
    }
    catch (const std::bad_alloc&)
    {
        return outOfMemory;
    }
    catch (const std::length_error&) // more than a container can hold
    {
        return outOfMemory;
    }
    catch (const std::exception& exception)
    {
        return std::string(prefix) + exception.what();
    }
}

/** Work that starts at once in a thread of oneTBB, and can be cancelled and waited for. */
class BackgroundTask
{
public:
    /** @param work returns early once isCancelled(); it must not throw. */
    explicit BackgroundTask(std::function<void()> work) : _work(std::move(work))
    {
        // A task that is cancelled before it begins never runs, but it is always destroyed, and this with it.
        const std::shared_ptr<void> atEnd(nullptr, [this](void*) { _hasEnded = true; });
        // Enqueued, so that a worker runs it even on a machine with one core, and even if no thread ever waits for it.
        _arena.enqueue(_group.defer([this, atEnd] { _work(); }));
    }
    ~BackgroundTask()
    {
        cancel();
        wait();
    }
    BackgroundTask(const BackgroundTask&) = delete;
    BackgroundTask& operator=(const BackgroundTask&) = delete;

    bool hasEnded() const { return _hasEnded; }
    /** Let the task count as ended before `work`, which calls this, returns. */
    void end() { _hasEnded = true; }

    void cancel()
    {
        _isCancelled = true;
        _group.cancel();
    }
    bool isCancelled() const { return _isCancelled; }

    /** Wait until the task has ended; this thread may work on it meanwhile. */
    void wait()
    {
        const std::lock_guard lock(_waitMutex);
        _arena.execute([this] { _group.wait(); });
    }

private:
    std::function<void()> _work;
    std::atomic<bool> _hasEnded{false};
    std::atomic<bool> _isCancelled{false};
    oneapi::tbb::task_arena _arena;
    oneapi::tbb::task_group _group;
    std::mutex _waitMutex;
};

} // namespace osgLego
