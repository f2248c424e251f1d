#include "ReadingGuard.h"

#include "ExitCode.h"
#include "ModelSize.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string_view>

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

namespace osgLego
{

namespace
{

constexpr std::size_t STACK_SIZE = 65536; // bytes, for a handler that needs less than a page

// Read by the handler, which must not allocate memory.
std::string crashMessage;
std::string timeMessage;

void endReading(int signal)
{
    const std::string& message = signal == SIGPROF ? timeMessage : crashMessage;
    // Nothing can be done if this fails.
    [[maybe_unused]] const ssize_t count = write(STDERR_FILENO, message.data(), message.size());
    _exit(EXIT_BAD_INPUT);
}

/** The bytes of address space that this process uses. */
std::uintmax_t findAddressSpace()
{
    std::uintmax_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uintmax_t>(sysconf(_SC_PAGESIZE));
}

void limitTime(time_t seconds)
{
    struct itimerval timer
    {
    };
    timer.it_value.tv_sec = seconds;
    setitimer(ITIMER_PROF, &timer, nullptr);
}

void limitMemory(std::uintmax_t bytes, const struct rlimit& former)
{
    struct rlimit limit = former;
    limit.rlim_cur = std::min<rlim_t>(findAddressSpace() + bytes, former.rlim_cur);
    setrlimit(RLIMIT_AS, &limit);
}

/** Have handlers run on a stack of their own, since an endless recursion fills the usual one. */
void setSignalStack()
{
    static std::array<char, STACK_SIZE> memory;
    stack_t stack{};
    stack.ss_sp = memory.data();
    stack.ss_size = memory.size();
    sigaltstack(&stack, nullptr);
}

} // namespace

ReadingGuard::ReadingGuard(const std::string& fileName)
{
    constexpr std::uintmax_t MEGABYTE = 1000000;
    constexpr time_t LEAST_TIME = 30;                        // seconds
    constexpr time_t TIME_PER_MEGABYTE = 2;                  // texts take about 0.1
    constexpr std::uintmax_t LEAST_MEMORY = 4000 * MEGABYTE; // textures may be larger than the file of the mesh
    constexpr std::uintmax_t MEMORY_PER_BYTE = 64;
    const std::uintmax_t size = findModelSize(fileName);
    const time_t time = LEAST_TIME + TIME_PER_MEGABYTE * static_cast<time_t>(size / MEGABYTE);
    crashMessage = fmt::format("osglegocapture: '{}': its reader has crashed; expected a file that is not damaged, and "
                               "a scene that does not contain itself\n",
                               fileName);
    timeMessage = fmt::format("osglegocapture: '{}': reading it takes more than {} seconds of processor time; expected "
                              "a file that is not damaged\n",
                              fileName, time);
    setSignalStack();
    struct sigaction action
    {
    };
    action.sa_handler = endReading;
    action.sa_flags = SA_ONSTACK;
    for (std::size_t index = 0; index < CRASH_SIGNALS.size(); ++index)
        sigaction(CRASH_SIGNALS[index], &action, &_former[index]);
    getrlimit(RLIMIT_AS, &_formerMemory);
    limitMemory(LEAST_MEMORY + MEMORY_PER_BYTE * size, _formerMemory);
    limitTime(time);
}

ReadingGuard::~ReadingGuard()
{
    limitTime(0);
    setrlimit(RLIMIT_AS, &_formerMemory);
    for (std::size_t index = 0; index < CRASH_SIGNALS.size(); ++index)
        sigaction(CRASH_SIGNALS[index], &_former[index], nullptr);
}

} // namespace osgLego
