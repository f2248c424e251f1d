#pragma once

#include <mutex>

namespace osgLego
{

/** Detects that a source moves, and how long its brick sets may rest, so that making them leaves time for drawing them.
 *
 * A source moves if its sets are requested in quick succession. Then a set that takes t seconds is followed by a rest
 * of 3 t, though never of more than LONGEST_REST.
 *
 * Usage:
 *
 *     MotionPace pace;
 *     const bool isMoving = pace.request(timer.time_s());
 *     if (isMoving) sleep(pace.getRest(timer.time_s()));
 *     ... // make the set
 *     pace.end(secondsOfWork, timer.time_s());
 *
 * Times are seconds since any fixed moment. Every function may be called from any thread.
 */
class MotionPace
{
public:
    static constexpr double PAUSE = 0.2;         //!< seconds; the requests of a source that moves are closer
    static constexpr double LONGEST_REST = 0.04; //!< seconds

    /** Note that a set was requested. @return whether the source moves. */
    bool request(double now);
    /** Note that the work on a set, or on its draft, has ended. @param seconds that it took. */
    void end(double seconds, double now);
    /** The time until the next set may begin. */
    double getRest(double now) const;

private:
    mutable std::mutex _mutex;
    double _lastRequest = -PAUSE;
    double _nextBeginning = 0.0;
};

} // namespace osgLego
