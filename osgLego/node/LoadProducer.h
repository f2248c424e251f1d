#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/store/BrickStore.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** Makes the set of stored bricks whose parts have colours for the load on their joints (colorByLoad), in a thread of
 * oneTBB. If the loads can't be computed, the parts keep their colours, and a warning says why.
 *
 * Every function may be called from any thread.
 */
class LoadProducer
{
public:
    /** @param announce called when a set is finished, in the thread that made it. */
    LoadProducer(BrickStore& store, std::function<void()> announce);
    ~LoadProducer();

    /** Begin to make the set of these bricks, and cancel work on others. @param revision of the set. */
    void produce(const BrickModel& bricks, std::uint64_t revision);
    void cancel();
    /** Deliver the set to the store if it is finished. @param waits wait for it. */
    void update(bool waits);

private:
    class Job;

    BrickStore& _store;
    std::function<void()> _announce;
    std::mutex _mutex;
    std::shared_ptr<Job> _job;
    std::vector<std::shared_ptr<Job>> _retired; // cancelled, but possibly still running
};

} // namespace osgLego
