#pragma once

#include <array>
#include <csignal>
#include <string>

#include <sys/resource.h>

namespace osgLego
{

/** Turns a crash of a reader of files into one message and EXIT_BAD_INPUT, and limits its memory and processor time:
 * readers of OSG don't survive all damaged files.
 *
 * Ends the program if a signal reports a crash, if the stack overflows, or if the time is over. Beyond the limit of
 * memory, allocations fail. Both limits are far above those of an intact file, by its size. Costs no measurable time,
 * while a separate process that tries to read the file first would need as long as the reading itself.
 *
 * One at a time, while nothing is being written. Signals of all threads are handled.
 */
class ReadingGuard
{
public:
    /** @param fileName may be one of pseudo-loaders. */
    explicit ReadingGuard(const std::string& fileName);
    ~ReadingGuard();
    ReadingGuard(const ReadingGuard&) = delete;
    ReadingGuard& operator=(const ReadingGuard&) = delete;

private:
    static constexpr std::array<int, 6> CRASH_SIGNALS{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPROF};

    std::array<struct sigaction, CRASH_SIGNALS.size()> _former{};
    struct rlimit _formerMemory
    {
    };
};

} // namespace osgLego
