#include "BrickMaking.h"

#include "Cancellation.h"

#include <chrono>
#include <future>
#include <system_error>

namespace osgLego
{

namespace
{

void show(const LegoProgress& progress, const ProgressBar& bar)
{
    switch (progress.stage)
    {
    case LegoProgress::Stage::PARTS:
        return bar.show(progress.fraction, "laying parts");
    case LegoProgress::Stage::CONNECTION:
        return bar.show(progress.fraction, "joining pieces");
    case LegoProgress::Stage::SUPPORT:
        return bar.show(progress.fraction, "supporting the model");
    case LegoProgress::Stage::IDLE:
    case LegoProgress::Stage::CELLS:
        bar.show("making bricks");
    }
}

/** Make bricks on a separate thread; if the system can't start one, in the first call that waits without a limit. */
std::future<void> startMaking(LegoNode& lego)
{
    const auto make = [&lego] { lego.getBricks(); };
    try
    {
        return std::async(std::launch::async, make);
    }
    catch (const std::system_error&)
    {
        return std::async(std::launch::deferred, make);
    }
}

} // namespace

void makeBricks(LegoNode& lego, const ProgressBar& progress)
{
    constexpr std::chrono::milliseconds INTERVAL(100);
    std::future<void> making = startMaking(lego);
    while (making.wait_for(INTERVAL) == std::future_status::timeout)
    {
        if (Cancellation::isRequested()) lego.cancel();
        show(lego.getProgress(), progress);
    }
    making.get();
    Cancellation::check();
}

} // namespace osgLego
