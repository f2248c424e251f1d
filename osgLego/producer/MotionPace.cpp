#include <osgLego/producer/MotionPace.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

namespace
{

constexpr double REST_OF_WORK = 3.0; // a quarter of the time for work leaves each core enough for drawing

} // namespace

bool MotionPace::request(double now)
{
    const std::lock_guard lock(_mutex);
    return now - std::exchange(_lastRequest, now) < PAUSE;
}

void MotionPace::end(double seconds, double now)
{
    const std::lock_guard lock(_mutex);
    _nextBeginning = now + std::min(REST_OF_WORK * seconds, LONGEST_REST);
}

double MotionPace::getRest(double now) const
{
    const std::lock_guard lock(_mutex);
    return std::clamp(_nextBeginning - now, 0.0, LONGEST_REST);
}

} // namespace osgLego
