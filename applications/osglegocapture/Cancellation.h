#pragma once

#include <array>
#include <string>

namespace osgLego
{

/** Records SIGINT, SIGTERM and SIGHUP, which then do not end the program, so that it can remove unfinished files. A
 * signal that the program was started to ignore is still ignored.
 *
 *     const Cancellation cancellation;
 *     options.isCancelled = Cancellation::isRequested;
 *     work(options);
 *     Cancellation::check();
 *
 * At most one object at a time; isRequested() may be called from any thread. */
class Cancellation
{
public:
    Cancellation();
    Cancellation(const Cancellation&) = delete;
    Cancellation& operator=(const Cancellation&) = delete;
    ~Cancellation();

    /** Work that does not ask isRequested(), while no file is half written: while this object exists, a
     * signal ends the program at once, with the message and the exit code of check(). */
    class Unasked
    {
    public:
        Unasked();
        Unasked(const Unasked&) = delete;
        Unasked& operator=(const Unasked&) = delete;
        ~Unasked();
    };

    /** Whether one of the signals has arrived. */
    static bool isRequested();
    /** Throws CaptureError, with the exit code of a program that the signal ended, if one has arrived.
     * @param message for the user. */
    static void check(const std::string& message = "cancelled");

private:
    using Handler = void (*)(int);

    std::array<Handler, 3> _former{}; // of the signals
};

} // namespace osgLego
