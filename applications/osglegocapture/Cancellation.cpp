#include "Cancellation.h"

#include "ExitCode.h"

#include <atomic>
#include <csignal>
#include <string_view>

#include <unistd.h>

namespace osgLego
{

namespace
{

constexpr std::array<int, 3> SIGNALS{SIGINT, SIGTERM, SIGHUP};
constexpr int BY_SIGNAL = 128;

// Signal handlers may only use atomic objects without locks.
std::atomic<int> arrived{0};
std::atomic<bool> isUnasked{false};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void note(int signal)
{
    constexpr std::string_view MESSAGE = "osglegocapture: cancelled\n";
    arrived = signal;
    if (!isUnasked) return;
    // Nothing can be done if this fails.
    [[maybe_unused]] const ssize_t count = write(STDERR_FILENO, MESSAGE.data(), MESSAGE.size());
    _exit(BY_SIGNAL + signal);
}

} // namespace

Cancellation::Cancellation()
{
    for (std::size_t index = 0; index < SIGNALS.size(); ++index)
    {
        struct sigaction former = {};
        sigaction(SIGNALS[index], nullptr, &former); // before it changes, so that no signal that is ignored arrives
        _former[index] = former.sa_handler;
        if (_former[index] != SIG_IGN) std::signal(SIGNALS[index], note);
    }
}

Cancellation::~Cancellation()
{
    for (std::size_t index = 0; index < SIGNALS.size(); ++index)
        std::signal(SIGNALS[index], _former[index]);
}

Cancellation::Unasked::Unasked()
{
    isUnasked = true;
    if (arrived != 0) note(arrived);
}

Cancellation::Unasked::~Unasked()
{
    isUnasked = false;
}

bool Cancellation::isRequested()
{
    return arrived != 0;
}

void Cancellation::check(const std::string& message)
{
    if (isRequested()) throw CaptureError(static_cast<ExitCode>(BY_SIGNAL + arrived), message);
}

} // namespace osgLego
