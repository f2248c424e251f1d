#include "ThreadSupply.h"

#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <oneapi/tbb/global_control.h>

namespace osgLego
{

namespace
{

/** Threads that all wait until this object is destroyed. */
class WaitingThreads
{
public:
    ~WaitingThreads()
    {
        {
            const std::lock_guard lock(_mutex);
            _mayEnd = true;
        }
        _change.notify_all();
        for (std::thread& thread : _threads)
            thread.join();
    }

    /** @return false if the system can't start another one. */
    bool add()
    try
    {
        _threads.emplace_back(
            [this]
            {
                std::unique_lock lock(_mutex);
                _change.wait(lock, [this] { return _mayEnd; });
            });
        return true;
    }
    catch (const std::system_error&)
    {
        return false;
    }
    catch (const std::bad_alloc&)
    {
        return false;
    }

private:
    std::mutex _mutex;
    std::condition_variable _change;
    bool _mayEnd = false;
    std::vector<std::thread> _threads;
};

/** Whether the system can start as many threads at once as this program and its libraries use. */
bool areThereEnoughThreads()
{
    // Those of oneTBB, OpenImageIO and Mesa's rasterizer, each one for each core, and single ones of Mesa and for
    // bricks.
    constexpr unsigned int POOLS = 3;
    constexpr unsigned int SINGLE = 6;
    const unsigned int count = POOLS * std::thread::hardware_concurrency() + SINGLE;
    WaitingThreads threads;
    for (unsigned int index = 0; index < count; ++index)
        if (!threads.add()) return false;
    return true;
}

/** Have OpenImageIO work in the calling thread. */
void setOneThreadForPictures()
try
{
    OIIO::attribute("threads", 1);
}
catch (const std::system_error&)
{
    // It still starts one for its pool, but only after it has taken the number over.
}

} // namespace

void adaptToThreadSupply()
{
    if (areThereEnoughThreads()) return;
    // Never destroyed, since oneTBB would then start a thread.
    using Control = oneapi::tbb::global_control;
    [[maybe_unused]] static const Control* const control = new Control(Control::max_allowed_parallelism, 1);
    setOneThreadForPictures();
    setenv("LP_NUM_THREADS", "0", 1); // of llvmpipe's rasterizer
}

} // namespace osgLego
