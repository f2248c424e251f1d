#include "Cancellation.h"

#include "ExitCode.h"

#include <atomic>
#include <csignal>

namespace osgLego
{

namespace
{

constexpr std::array<int, 2> SIGNALS{SIGINT, SIGTERM};

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
    for (std::size_t index = 0; index < SIGNALS.size(); ++index)
    {
        _former[index] = std::signal(SIGNALS[index], note);
        if (_former[index] == SIG_IGN) std::signal(SIGNALS[index], SIG_IGN);
    }
}

Cancellation::~Cancellation()
{
    for (std::size_t index = 0; index < SIGNALS.size(); ++index)
        std::signal(SIGNALS[index], _former[index]);
}

bool Cancellation::isRequested()
{
    return arrived != 0;
}

void Cancellation::check()
{
    constexpr int BY_SIGNAL = 128;
    if (isRequested())
        throw CaptureError(static_cast<ExitCode>(BY_SIGNAL + arrived), "cancelled; the booklet was not written");
}

} // namespace osgLego
