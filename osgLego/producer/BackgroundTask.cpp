#include <osgLego/producer/BackgroundTask.h>

#include <chrono>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace osgLego
{

namespace
{

std::string describe(const std::exception& exception, std::string outOfMemory, const std::string& prefix)
{
    try
    {
        return prefix + exception.what();
    }
    catch (const std::bad_alloc&)
    {
        return outOfMemory;
    }
}

} // namespace

std::string catchFailure(const std::function<void()>& work, std::string outOfMemory, const std::string& prefix)
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
        return describe(exception, std::move(outOfMemory), prefix);
    }
}

BackgroundTask::~BackgroundTask()
{
    cancel();
    if (_thread.joinable()) _thread.join();
}

void BackgroundTask::start()
{
    // Not a task of oneTBB: if oneTBB can't start its threads, such a task would wait for one indefinitely.
    try
    {
        _thread = std::thread([this] { run(); });
    }
    catch (const std::system_error&) // no more threads
    {
        run();
    }
    catch (const std::bad_alloc&) // no memory for a thread
    {
        run();
    }
}

void BackgroundTask::cancel()
{
    _isCancelled = true;
    _group.cancel();
    wake();
}

void BackgroundTask::wait(double seconds, const std::function<bool()>& isEnough) const
{
    constexpr double LONGEST = 1e6; // which clocks can count
    const auto isOver = [&] { return _hasEnded || (isEnough && isEnough()); };
    std::unique_lock lock(_waitMutex);
    if (isOver()) return;
    ++_numWaiting;
    _change.notify_all();
    if (seconds < LONGEST)
        _change.wait_for(lock, std::chrono::duration<double>(seconds), isOver);
    else
        _change.wait(lock, isOver);
    --_numWaiting;
}

void BackgroundTask::wake() const
{
    {
        // A thread that has just checked its condition is then waiting already.
        const std::lock_guard lock(_waitMutex);
    }
    _change.notify_all();
}

void BackgroundTask::rest(double seconds) const
{
    std::unique_lock lock(_waitMutex);
    _change.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return _isCancelled || _numWaiting > 0; });
}

void BackgroundTask::run()
{
    // In the group, so that cancelling it ends loops of oneTBB. Outside of it, oneTBB may report that it has no
    // threads.
    // The sentence is moved rather than copied: an exception that leaves a thread ends the program.
    std::string failure = catchFailure([this] { _group.run_and_wait([this] { _steps.work(); }); },
                                       std::move(_steps.outOfMemory), _steps.prefix);
    _steps.work = nullptr; // and all that it holds
    _steps.settle(std::move(failure));
    _hasEnded = true;
    wake();
    _steps.announce();
    _hasReturned = true;
}

} // namespace osgLego
