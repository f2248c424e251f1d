#include <osgLego/producer/CpuProducer.h>

#include <osgLego/model/CpuBricks.h>
#include <osgLego/producer/BackgroundTask.h>
#include <osgLego/stability/LoadColors.h>

#include <string>
#include <utility>

namespace osgLego
{

namespace
{

constexpr const char* OUT_OF_MEMORY = "there is not enough memory for all bricks; expected a lower resolution";

} // namespace

/** A background task that makes one set. It can be cancelled and waited for. */
class CpuProducer::Job
{
public:
    /** @param layout of the set before, if there is one. */
    Job(const LegoSource& source, PreviousLayout layout, const std::function<void()>& announce) :
        _source(&source), _layout(std::move(layout)), _announce(announce), _task([this] { run(); })
    {
    }

    bool isOf(const LegoSource& source) const { return _source->revision == source.revision; }
    /** Whether the task has ended, with or without a set. */
    bool hasEnded() const { return _task.hasEnded(); }
    /** The set; null until the task has ended, and also if it was cancelled or has failed. */
    osg::ref_ptr<const BrickSet> getBricks() const { return hasEnded() ? _bricks : nullptr; }
    /** The reason why there is no set after the task has ended, unless it was cancelled. */
    const std::string& getError() const { return _error; }
    /** The parts of the set, for the next one. Only after the task has ended. */
    const PreviousLayout& getLayout() const { return _layout; }

    void cancel() { _task.cancel(); }
    bool isCancelled() const { return _task.isCancelled(); }
    void wait() { _task.wait(); }

private:
    void run()
    {
        const std::string failure = catchFailure([this] { makeBricks(); }, OUT_OF_MEMORY, "the bricks can't be made: ");
        if (!failure.empty()) _error = failure;
        const bool isMade = _bricks.valid();
        _task.end();
        if (isMade && _announce) _announce();
    }

    void makeBricks()
    {
        CpuBricksWork work;
        work.isCancelled = [this] { return _task.isCancelled(); };
        work.previous = &_layout;
        const osg::ref_ptr<const BrickModel> model = makeBricksOnCpu(*_source, work);
        osg::ref_ptr<const BrickModel> shown = model;
        if (model && _source->settings.show == Show::LOAD) shown = colorByLoad(*model, work.isCancelled);
        if (shown) _bricks = new BrickSet(_source->revision, *model, work.statistics, work.measureLayout, shown.get());
        _error = work.error;
    }

    osg::ref_ptr<const LegoSource> _source;
    PreviousLayout _layout;
    std::function<void()> _announce;
    osg::ref_ptr<const BrickSet> _bricks;
    std::string _error;
    BackgroundTask _task; // last, so that it has ended before the other members are destroyed
};

CpuProducer::CpuProducer(BrickStore& store, std::function<void()> announce) :
    _store(&store), _announce(std::move(announce))
{
}

CpuProducer::~CpuProducer() = default;

void CpuProducer::produce(const LegoSource& source, osgUtil::CullVisitor& visitor, bool waits)
{
    bool isNew = false;
    const std::shared_ptr<Job> job = start(source, waits, isNew);
    if (waits) job->wait();
    // A set that was begun in this frame belongs to a later one, however fast it was made.
    if (!job || (isNew && !waits) || !job->hasEnded() || job->isCancelled()) return;
    if (const osg::ref_ptr<const BrickSet> bricks = job->getBricks())
        _store->deliver(*bricks);
    else
        _store->getContext(visitor.getState()->getContextID())->fail(source.revision, job->getError());
}

/** The job of a source: the one there is, or a new one in place of the job of another source.
 * @return null if that job is to be finished first. */
std::shared_ptr<CpuProducer::Job> CpuProducer::start(const LegoSource& source, bool waits, bool& isNew)
{
    const std::lock_guard lock(_mutex);
    if (_job && _job->isOf(source)) return _job;
    const bool isRunning = _job && !_job->hasEnded();
    // A source that changes faster than its bricks are made is shown as it was at times, or it would never be shown.
    if (isRunning && _hasGivenUp && !waits) return nullptr;
    _hasGivenUp = isRunning;
    if (_job && !isRunning)
        if (const osg::ref_ptr<const BrickSet> bricks = _job->getBricks()) _store->deliver(*bricks);
    if (_job && !isRunning) _layout = _job->getLayout();
    retire();
    _job = std::make_shared<Job>(source, _layout, _announce);
    isNew = true;
    return _job;
}

void CpuProducer::update(unsigned int)
{
    const std::lock_guard lock(_mutex);
    std::erase_if(_retired, [](const std::shared_ptr<Job>& job) { return job->hasEnded(); });
    if (!_job) return;
    if (const osg::ref_ptr<const BrickSet> bricks = _job->getBricks()) _store->deliver(*bricks);
}

void CpuProducer::cancel()
{
    const std::lock_guard lock(_mutex);
    retire();
}

/** Cancel the current job, without waiting for it to end. */
void CpuProducer::retire()
{
    if (!_job) return;
    _job->cancel();
    _retired.push_back(std::move(_job));
}

osg::ref_ptr<const BrickSet> CpuProducer::getBricks(const LegoSource& source, std::string& error)
{
    bool isNew = false;
    const std::shared_ptr<Job> job = start(source, true, isNew);
    job->wait();
    error = job->getError();
    return job->getBricks();
}

} // namespace osgLego
