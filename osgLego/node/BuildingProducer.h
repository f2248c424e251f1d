#pragma once

#include <osgLego/BuildingPlan.h>
#include <osgLego/data/BrickSet.h>
#include <osgLego/data/BuildingSet.h>
#include <osgLego/store/BrickStore.h>

#include <functional>
#include <memory>
#include <mutex>

#include <osg/ref_ptr>

namespace osgLego
{

/** Prepares brick sets for being drawn partly built (BuildingSet), in a thread of oneTBB: plans the order of building,
 * unless there is a plan that fits.
 *
 * Every function may be called from any thread.
 */
class BuildingProducer
{
public:
    /** @param announce called when a set is finished, in the thread that made it. */
    BuildingProducer(BrickStore& store, std::function<void()> announce);
    ~BuildingProducer();

    /** Set the order of building; null: that of planBuilding(). */
    void setPlan(const BuildingPlan* plan);
    osg::ref_ptr<const BuildingPlan> getPlan() const;

    /** Deliver the set of these bricks to the store, or begin to make it. While a set of older bricks is being made, it
     * is finished first, so that bricks that are remade all the time are shown, too.
     * @param waits wait for the set of these bricks. */
    void produce(const BrickSet& bricks, bool waits);

private:
    class Job;

    std::shared_ptr<Job> start(const BrickSet& bricks, bool waits);

    osg::ref_ptr<BrickStore> _store;
    std::function<void()> _announce;
    mutable std::mutex _mutex;
    osg::ref_ptr<const BuildingPlan> _plan;
    std::shared_ptr<Job> _job; // the last one
};

} // namespace osgLego
