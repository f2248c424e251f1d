#include "Cancellation.h"

#include "../ExitCode.h"

#include <atomic>
#include <csignal>

namespace osgLego
{

namespace
{

// Signal handlers may only use atomic objects without locks.
std::atomic<int> arrived{0};
static_assert(std::atomic<int>::is_always_lock_free);

void note(int signal)
{
    arrived = signal;
}

} // namespace

Cancellation::Cancellation()
{
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
}

Cancellation::~Cancellation()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool Cancellation::isRequested()
{
    return arrived != 0;
}

void Cancellation::check()
{
    constexpr int BY_SIGNAL = 128;
    if (isRequested()) throw CaptureError(static_cast<ExitCode>(BY_SIGNAL + arrived), "cancelled; nothing was written");
}

} // namespace osgLego
