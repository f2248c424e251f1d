#pragma once

#include <osgLego/BuildingPlan.h>
#include <osgLego/data/BrickSet.h>
#include <osgLego/data/BuildingSet.h>
#include <osgLego/producer/BackgroundJob.h>
#include <osgLego/store/BrickStore.h>

#include <functional>
#include <mutex>

#include <osg/ref_ptr>

namespace osgLego
{

/** Prepares brick sets for being drawn partly built (BuildingSet), in the background: plans the order of building,
 * unless there is a plan that fits. If a set can't be made, a warning says why.
 *
 * Every function may be called from any thread.
 */
class BuildingProducer
{
public:
    /** @param announce called when a set is finished, in the thread that made it. */
    BuildingProducer(BrickStore& store, std::function<void()> announce);

    /** Set the order of building; null: that of planBuilding(). */
    void setPlan(const BuildingPlan* plan);
    osg::ref_ptr<const BuildingPlan> getPlan() const;

    /** Deliver the set of these bricks to the store, or begin to make it. Cancels work on older bricks, though never
     * twice in a row, so that bricks that are remade all the time are shown, too.
     * @param seconds to wait for the set of these bricks. */
    void produce(const BrickSet& bricks, double seconds);
    /** Deliver the set that was made last, unless it has been delivered. */
    void update() { _job.deliver(); }
    /** Whether a set is being made or has not been delivered. */
    bool isBusy() const { return _job.isBusy(); }

private:
    using Job = BackgroundJob<osg::ref_ptr<const BuildingSet>>;

    osg::ref_ptr<BrickStore> _store;
    mutable std::mutex _mutex; // guards the plan
    osg::ref_ptr<const BuildingPlan> _plan;
    Job _job;
};

} // namespace osgLego
