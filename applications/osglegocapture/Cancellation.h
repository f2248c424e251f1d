#pragma once

#include <array>

namespace osgLego
{

/** Notes SIGINT and SIGTERM instead of being ended by them, so that unfinished files can be removed. A signal that
 * the program was started to ignore is still ignored.
 *
 * At most one object at a time; isRequested() may be called from any thread. */
class Cancellation
{
public:
    Cancellation();
    Cancellation(const Cancellation&) = delete;
    Cancellation& operator=(const Cancellation&) = delete;
    ~Cancellation();

    /** Whether one of the signals has arrived. */
    static bool isRequested();
    /** Throws CaptureError, with the exit code of a program that the signal ended, if one has arrived. */
    static void check();

private:
    using Handler = void (*)(int);

    std::array<Handler, 2> _former{}; // of SIGINT and SIGTERM
};

} // namespace osgLego
