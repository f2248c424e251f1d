#include <osgLego/node/LoadProducer.h>

#include <osgLego/producer/BackgroundTask.h>
#include <osgLego/stability/LoadColors.h>

#include <string>
#include <utility>

#include <osg/Notify>

namespace osgLego
{

namespace
{

constexpr const char* OUT_OF_MEMORY = "there is not enough memory for it; expected fewer parts";

} // namespace

/** A background task that makes one set. */
class LoadProducer::Job
{
public:
    Job(const BrickModel& bricks, std::uint64_t revision, const std::function<void()>& announce) :
        _model(&bricks), _revision(revision), _announce(announce), _task([this] { run(); })
    {
    }

    bool hasEnded() const { return _task.hasEnded(); }
    /** The set; null until the task has ended, and also if it was cancelled. */
    osg::ref_ptr<const BrickSet> getBricks() const { return hasEnded() ? _bricks : nullptr; }
    void cancel() { _task.cancel(); }
    void wait() { _task.wait(); }

private:
    void run()
    {
        warn(catchFailure([this] { makeBricks(); }, OUT_OF_MEMORY));
        const bool isMade = _bricks.valid();
        _task.end();
        if (isMade && _announce) _announce();
    }

    void makeBricks()
    {
        const osg::ref_ptr<const BrickModel> shown = makeShown();
        if (!shown) return;
        LegoStatistics statistics;
        statistics.isStored = true;
        _bricks = new BrickSet(_revision, *_model, statistics, {}, shown.get());
    }

    /** The model in the colours to show; null if it was cancelled. */
    osg::ref_ptr<const BrickModel> makeShown() const
    {
        osg::ref_ptr<const BrickModel> shown;
        const std::string failure =
            catchFailure([&] { shown = colorByLoad(*_model, [this] { return _task.isCancelled(); }); }, OUT_OF_MEMORY);
        warn(failure);
        return failure.empty() ? shown : _model;
    }

    /** Print a reason, if there is one. */
    static void warn(const std::string& reason)
    {
        if (reason.empty()) return;
        OSG_WARN << "osgLego: parts keep their colours, because the load on their joints can't be computed: " << reason
                 << std::endl;
    }

    osg::ref_ptr<const BrickModel> _model;
    std::uint64_t _revision;
    std::function<void()> _announce;
    osg::ref_ptr<const BrickSet> _bricks;
    BackgroundTask _task; // last, so that it has ended before the other members are destroyed
};

LoadProducer::LoadProducer(BrickStore& store, std::function<void()> announce) :
    _store(store), _announce(std::move(announce))
{
}

LoadProducer::~LoadProducer() = default;

void LoadProducer::produce(const BrickModel& bricks, std::uint64_t revision)
{
    cancel();
    const std::lock_guard lock(_mutex);
    _job = std::make_shared<Job>(bricks, revision, _announce);
}

void LoadProducer::cancel()
{
    const std::lock_guard lock(_mutex);
    if (!_job) return;
    _job->cancel();
    _retired.push_back(std::move(_job));
}

void LoadProducer::update(bool waits)
{
    std::shared_ptr<Job> job;
    {
        const std::lock_guard lock(_mutex);
        std::erase_if(_retired, [](const std::shared_ptr<Job>& retired) { return retired->hasEnded(); });
        job = _job;
    }
    if (!job) return;
    if (waits) job->wait();
    if (const osg::ref_ptr<const BrickSet> bricks = job->getBricks()) _store.deliver(*bricks);
}

} // namespace osgLego
