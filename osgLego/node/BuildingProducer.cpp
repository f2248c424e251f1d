#include <osgLego/node/BuildingProducer.h>

#include <osgLego/BuildingPlanner.h>
#include <osgLego/producer/BackgroundTask.h>

#include <string>
#include <utility>

#include <osg/Notify>

namespace osgLego
{

namespace
{

constexpr const char* OUT_OF_MEMORY = "there is not enough memory for it; expected a lower resolution";

} // namespace

/** A background task that makes one set. */
class BuildingProducer::Job
{
public:
    /** @param plan null: made by the task. */
    Job(const BrickSet& bricks, const BuildingPlan* plan, const std::function<void()>& announce) :
        _bricks(&bricks), _plan(plan), _announce(announce), _task([this] { run(); })
    {
    }

    bool isOf(const BrickSet& bricks, const BuildingPlan* plan) const
    {
        return _bricks->getRevision() == bricks.getRevision() && _plan == plan;
    }
    bool hasEnded() const { return _task.hasEnded(); }
    /** The set; null until the task has ended, and also if it was cancelled or has failed. */
    osg::ref_ptr<const BuildingSet> getBuilding() const { return hasEnded() ? _building : nullptr; }
    void wait() { _task.wait(); }

private:
    void run()
    {
        const std::string failure = catchFailure([this] { makeBuilding(); }, OUT_OF_MEMORY);
        if (!failure.empty())
            OSG_WARN << "osgLego: all parts are shown, because the order of building can't be made: " << failure
                     << std::endl;
        const bool isMade = _building.valid();
        _task.end();
        if (isMade && _announce) _announce();
    }

    void makeBuilding()
    {
        const osg::ref_ptr<const BrickModel> model = _bricks->getModel();
        if (!model) return;
        osg::ref_ptr<const BuildingPlan> plan;
        if (!model->getParts().empty())
        {
            const bool fits = _plan && _plan->getOrder().size() == model->getParts().size();
            plan = fits ? _plan : makePlan(*model);
            if (!plan) return;
        }
        _building = new BuildingSet(_bricks->getRevision(), *model, plan);
    }

    osg::ref_ptr<const BuildingPlan> makePlan(const BrickModel& model) const
    {
        PlanningOptions options;
        options.checksStability = false; // takes longer than a viewer should wait
        options.isCancelled = [this] { return _task.isCancelled(); };
        return planBuilding(model, options);
    }

    osg::ref_ptr<const BrickSet> _bricks;
    osg::ref_ptr<const BuildingPlan> _plan;
    std::function<void()> _announce;
    osg::ref_ptr<const BuildingSet> _building;
    BackgroundTask _task; // last, so that it has ended before the other members are destroyed
};

BuildingProducer::BuildingProducer(BrickStore& store, std::function<void()> announce) :
    _store(&store), _announce(std::move(announce))
{
}

BuildingProducer::~BuildingProducer() = default;

void BuildingProducer::setPlan(const BuildingPlan* plan)
{
    const std::lock_guard lock(_mutex);
    _plan = plan;
}

osg::ref_ptr<const BuildingPlan> BuildingProducer::getPlan() const
{
    const std::lock_guard lock(_mutex);
    return _plan;
}

void BuildingProducer::produce(const BrickSet& bricks, bool waits)
{
    const std::shared_ptr<Job> job = start(bricks, waits);
    if (waits) job->wait();
    if (const osg::ref_ptr<const BuildingSet> building = job->getBuilding()) _store->deliver(*building);
}

/** The job of a brick set: the one there is, or a new one, or that of an older set if it is to be finished first. */
std::shared_ptr<BuildingProducer::Job> BuildingProducer::start(const BrickSet& bricks, bool waits)
{
    std::shared_ptr<Job> old; // ends after the lock
    const std::lock_guard lock(_mutex);
    if (_job && (_job->isOf(bricks, _plan) || !(_job->hasEnded() || waits))) return _job;
    if (_job)
        if (const osg::ref_ptr<const BuildingSet> building = _job->getBuilding()) _store->deliver(*building);
    old = std::exchange(_job, std::make_shared<Job>(bricks, _plan, _announce));
    return _job;
}

} // namespace osgLego
