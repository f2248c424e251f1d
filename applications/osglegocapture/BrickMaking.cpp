#include "BrickMaking.h"

#include "Cancellation.h"

#include <chrono>
#include <future>

namespace osgLego
{

namespace
{

void show(const LegoProgress& progress, const ProgressBar& bar)
{
    if (progress.stage == LegoProgress::Stage::PARTS)
        bar.show(progress.fraction, "laying parts");
    else
        bar.show("making bricks");
}

} // namespace

void makeBricks(LegoNode& lego, const ProgressBar& progress)
{
    constexpr std::chrono::milliseconds INTERVAL(100);
    std::future<void> making = std::async(std::launch::async, [&lego] { lego.getBricks(); });
    while (making.wait_for(INTERVAL) != std::future_status::ready)
    {
        if (Cancellation::isRequested()) lego.cancel();
        show(lego.getProgress(), progress);
    }
    making.get();
    Cancellation::check();
}

} // namespace osgLego
