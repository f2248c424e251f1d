#pragma once

namespace osgLego
{

/** Notes SIGINT and SIGTERM instead of being ended by them, so that unfinished files can be removed.
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
};

} // namespace osgLego
