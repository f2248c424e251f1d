#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <limits>
#include <mutex>
#include <string>
#include <thread>

#include <oneapi/tbb/task_group.h>

namespace osgLego
{

/** Do work that may throw. Throws nothing itself, even if there is no memory at all.
 * @param outOfMemory the sentence for a lack of memory. @param prefix comes before the reason of any other failure.
 * @return the reason why the work failed; empty if it did not. */
std::string catchFailure(const std::function<void()>& work, std::string outOfMemory, const std::string& prefix = {});

/** Work on a separate thread, which can be cancelled and waited for. Loops of oneTBB in the work use the threads of
 * oneTBB as well, and end early when it is cancelled.
 *
 * Every function except start() may be called from any thread.
 */
class BackgroundTask
{
public:
    /** The steps of a task, one after another. */
    struct Steps
    {
        std::function<void()> work; //!< returns early once isCancelled(); may throw; not called if cancelled before
        std::string outOfMemory;    //!< see catchFailure()
        std::string prefix;
        std::function<void(std::string&& failure)> settle; //!< called before the task counts as ended; must not throw
        std::function<void()> announce;                    //!< called after that; must not throw
    };

    static constexpr double FOREVER = std::numeric_limits<double>::infinity(); //!< seconds

    explicit BackgroundTask(Steps steps) : _steps(std::move(steps)) {}
    /** Cancels the task, and waits until it has ended. */
    ~BackgroundTask();
    BackgroundTask(const BackgroundTask&) = delete;
    BackgroundTask& operator=(const BackgroundTask&) = delete;

    /** Start a thread for the task; if the system can't provide one, do it now, in this thread. Called once. */
    void start();
    bool hasEnded() const { return _hasEnded; }
    /** Whether it has ended and its announcement has returned, so that destroying the task waits for nothing. */
    bool hasReturned() const { return _hasReturned; }
    void cancel();
    bool isCancelled() const { return _isCancelled; }
    /** Wait until the task has ended, or for a number of seconds. Another thread may start it meanwhile.
     * @param isEnough also ends the wait by returning true, and is called after each wake(); may be empty. */
    void wait(double seconds = FOREVER, const std::function<bool()>& isEnough = {}) const;
    /** Have the threads that wait check whether they have waited enough. */
    void wake() const;
    /** Sleep for a number of seconds in the task itself: less if it is cancelled, or if another thread waits for it. */
    void rest(double seconds) const;

private:
    void run();

    Steps _steps;
    mutable std::mutex _waitMutex;
    mutable std::condition_variable _change; // notified after changes that end a wait or a rest
    mutable int _numWaiting = 0;             // threads; guarded by the mutex
    std::atomic<bool> _hasEnded{false};
    std::atomic<bool> _hasReturned{false};
    std::atomic<bool> _isCancelled{false};
    oneapi::tbb::task_group _group;
    std::thread _thread;
};

} // namespace osgLego
