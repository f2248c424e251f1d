#include <osgLego/producer/BackgroundTask.h>

#include <chrono>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

namespace osgLego
{

std::string catchFailure(const std::function<void()>& work, const std::string& outOfMemory, const std::string& prefix)
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
        return prefix + exception.what();
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
}

void BackgroundTask::wait(double seconds) const
{
    constexpr double LONGEST = 1e6; // which clocks can count
    const auto hasEnded = [this] { return _hasEnded.load(); };
    std::unique_lock lock(_endMutex);
    if (seconds < LONGEST)
        _end.wait_for(lock, std::chrono::duration<double>(seconds), hasEnded);
    else
        _end.wait(lock, hasEnded);
}

void BackgroundTask::run()
{
    // In the group, so that cancelling it ends loops of oneTBB. Outside of it, oneTBB may report that it has no
    // threads.
    const std::string failure =
        catchFailure([this] { _group.run_and_wait([this] { _steps.work(); }); }, _steps.outOfMemory, _steps.prefix);
    _steps.work = nullptr; // and all that it holds
    _steps.settle(failure);
    {
        const std::lock_guard lock(_endMutex);
        _hasEnded = true;
    }
    _end.notify_all();
    _steps.announce();
    _hasReturned = true;
}

} // namespace osgLego
