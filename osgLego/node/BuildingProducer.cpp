#include <osgLego/node/BuildingProducer.h>

#include <osgLego/BuildingPlanner.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <osg/Notify>

namespace osgLego
{

namespace
{

constexpr const char* OUT_OF_MEMORY = "there is not enough memory for it; expected a lower resolution";

/** The plan, if it is for the parts of the model, or else that of planBuilding(); null if it was cancelled. */
osg::ref_ptr<const BuildingPlan> findPlan(const BrickModel& model, const BuildingPlan* plan,
                                          const std::function<bool()>& isCancelled)
{
    if (plan && plan->getOrder().size() == model.getParts().size()) return plan;
    PlanningOptions options;
    options.checksStability = false; // takes longer than a viewer should wait
    options.isCancelled = isCancelled;
    return planBuilding(model, options);
}

/** @return null if it was cancelled. */
osg::ref_ptr<const BuildingSet> createSet(const BrickSet& bricks, const BuildingPlan* given,
                                          const std::function<bool()>& isCancelled)
{
    const osg::ref_ptr<const BrickModel> model = bricks.getModel();
    if (!model) throw std::runtime_error("the bricks can't be made on the CPU");
    osg::ref_ptr<const BuildingPlan> plan;
    if (!model->getParts().empty())
    {
        plan = findPlan(*model, given, isCancelled);
        if (!plan) return nullptr;
    }
    return new BuildingSet(bricks.getRevision(), *model, plan);
}

void warn(const std::string& failure)
{
    OSG_WARN << "osgLego: all parts are shown, because the order of building can't be made: " << failure << std::endl;
}

} // namespace

BuildingProducer::BuildingProducer(BrickStore& store, std::function<void()> announce) :
    _store(&store),
    _job({.outOfMemory = OUT_OF_MEMORY,
          .deliver = [this](const osg::ref_ptr<const BuildingSet>& building) { _store->deliver(*building); },
          .fail = warn,
          .announce = std::move(announce)})
{
}

void BuildingProducer::setPlan(const BuildingPlan* plan)
{
    {
        const std::lock_guard lock(_mutex);
        if (plan == _plan) return;
        _plan = plan;
    }
    _job.cancel();
}

osg::ref_ptr<const BuildingPlan> BuildingProducer::getPlan() const
{
    const std::lock_guard lock(_mutex);
    return _plan;
}

void BuildingProducer::produce(const BrickSet& bricks, double seconds)
{
    const auto createWork = [&]
    {
        return [bricks = osg::ref_ptr<const BrickSet>(&bricks),
                plan = getPlan()](const Job::Run& run, std::string&) -> std::optional<osg::ref_ptr<const BuildingSet>>
        {
            const osg::ref_ptr<const BuildingSet> building =
                createSet(*bricks, plan, [&run] { return run.isCancelled(); });
            return building ? std::optional(building) : std::nullopt;
        };
    };
    const std::shared_ptr<Job::Run> run =
        _job.request(bricks.getRevision(), seconds == BackgroundTask::FOREVER, createWork).run;
    if (run && seconds > 0.0) run->wait(seconds);
    _job.deliver();
}

} // namespace osgLego
