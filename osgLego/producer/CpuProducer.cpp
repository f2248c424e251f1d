#include <osgLego/producer/CpuProducer.h>

#include <osgLego/stability/LoadColors.h>

#include <new>
#include <optional>
#include <utility>

#include <osg/Notify>
#include <osg/Timer>

namespace osgLego
{

namespace
{

constexpr const char* OUT_OF_MEMORY = "there is not enough memory for all bricks; expected a lower resolution";
constexpr const char* NO_MEMORY_FOR_LOADS = "there is not enough memory for it; expected fewer parts";

/** A model in colours for the load on its joints, or in its own if the loads can't be computed.
 * @return null if it was cancelled. */
osg::ref_ptr<const BrickModel> tryToColorByLoad(const BrickModel& model, const std::function<bool()>& isCancelled)
{
    osg::ref_ptr<const BrickModel> colored;
    const std::string failure = catchFailure([&] { colored = colorByLoad(model, isCancelled); }, NO_MEMORY_FOR_LOADS);
    if (failure.empty()) return colored;
    OSG_WARN << "osgLego: parts keep their colours, because the load on their joints can't be computed: " << failure
             << std::endl;
    return &model;
}

/** Whether the parts of a source are worth a draft that is shown before them. */
bool deservesDraft(const LegoSettings& settings, bool isMoving)
{
    return settings.parts.set != PartSet::NONE && (isMoving || settings.parts.effort != Effort::INSTANT);
}

double getNow()
{
    return osg::Timer::instance()->time_s();
}

/** The set of a model in the colours to show; null if it was cancelled. */
osg::ref_ptr<const BrickSet> createSet(std::uint64_t revision, const BrickModel& model, Show show,
                                       const LegoStatistics& statistics, const BrickSet::MeasureLayout& measureLayout,
                                       const std::function<bool()>& isCancelled)
{
    osg::ref_ptr<const BrickModel> shown = &model;
    if (show == Show::LOAD) shown = tryToColorByLoad(model, isCancelled);
    return shown ? new BrickSet(revision, model, statistics, measureLayout, shown.get()) : nullptr;
}

} // namespace

CpuProducer::CpuProducer(BrickStore& store, std::function<void()> announce) :
    _store(&store), _job({.outOfMemory = OUT_OF_MEMORY,
                          .prefix = "the bricks can't be made: ",
                          .deliver = [this](const Made& made) { deliver(made); },
                          .announce = std::move(announce)})
{
}

void CpuProducer::produce(const LegoSource& source, osgUtil::CullVisitor& visitor, const FrameNeeds& needs)
{
    if (needs.neighbors) _computesNeighbors = true;
    if (needs.distantOcclusion) _computesDistantOcclusion[static_cast<std::size_t>(*needs.distantOcclusion)] = true;
    // Within a limit, bricks of a source that changes in every frame might never be made.
    const bool isUrgent = needs.seconds == BackgroundTask::FOREVER;
    const auto [run, isNew] = request(source, isUrgent, isUrgent && !needs.onlyDraft);
    // A set that was begun in this frame belongs to a later one, however fast it was made.
    if (!run || (isNew && needs.seconds <= 0.0)) return;
    if (needs.seconds > 0.0) needs.onlyDraft ? run->waitForDraft(needs.seconds) : run->wait(needs.seconds);
    _job.deliver();
    if (run->getOutcome() == Job::Outcome::FAILED)
        _store->getContext(visitor.getState()->getContextID())->fail(source.revision, run->getFailure());
}

/** @param isAwaited whether the caller waits for the bricks, so that a draft is of no use. */
CpuProducer::Job::Request CpuProducer::request(const LegoSource& source, bool isUrgent, bool isAwaited)
{
    const auto createWork = [&]
    {
        const bool isMoving = _pace.request(getNow()) && !isAwaited;
        return [this, source = osg::ref_ptr<const LegoSource>(&source), previous = _bricks, shown = _shownBricks,
                progress = begin(source.settings), isAwaited, isMoving](Job::Run& run, std::string& error)
        {
            if (isMoving) run.rest(_pace.getRest(getNow()));
            const double start = getNow();
            PreviousLayout layout = previous->layout;
            CpuBricksWork work;
            work.isCancelled = [&run] { return run.isCancelled(); };
            work.progress = [&progress](const LegoProgress& reached) { *progress = reached; };
            work.previous = &layout;
            work.shown = &shown->layout;
            work.isDraftGreedy = isMoving;
            bool hasDraft = false;
            if (!isAwaited && deservesDraft(source->settings, isMoving))
                work.showDraft = [&](const BrickModel& draft, PreviousLayout&& draftLayout)
                {
                    hasDraft = true;
                    *progress = LegoProgress{LegoProgress::Stage::PARTS};
                    const osg::ref_ptr<const BrickSet> set =
                        new BrickSet(source->getDraftRevision(), draft, work.statistics, work.measureLayout);
                    complete(*set, isMoving);
                    _pace.end(getNow() - start, getNow());
                    const osg::ref_ptr<MadeBricks> bricks = new MadeBricks;
                    bricks->layout = std::move(draftLayout);
                    run.offer({set, bricks, true});
                    if (isMoving) run.rest(MotionPace::PAUSE);
                };
            std::optional<Made> made = make(*source, work, isMoving, error);
            if (!hasDraft) _pace.end(getNow() - start, getNow());
            return made;
        };
    };
    return _job.request(source.revision, isUrgent || hasOtherSettings(source), createWork);
}

/** Make the set of a source. @return nothing if that was cancelled, or with a sentence in `error`. */
std::optional<CpuProducer::Made> CpuProducer::make(const LegoSource& source, CpuBricksWork& work, bool isMoving,
                                                   std::string& error)
{
    const osg::ref_ptr<const MadeBricks> bricks = makeOrFind(source, work);
    error = work.error;
    if (!bricks) return std::nullopt;
    warn(bricks->warning);
    const osg::ref_ptr<const BrickSet> set = createSet(source.revision, *bricks->model, source.settings.view.show,
                                                       work.statistics, bricks->measureLayout, work.isCancelled);
    if (!set) return std::nullopt;
    complete(*set, isMoving);
    return Made{set, bricks};
}

/** Make the bricks of a source, unless another producer has the same. @return null if that was cancelled, or with a
 * sentence in `work.error`. */
osg::ref_ptr<const MadeBricks> CpuProducer::makeOrFind(const LegoSource& source, CpuBricksWork& work)
{
    const auto isAlike = [&](const PreviousLayout& layout)
    { return layout.cells && layout.settings.givesSameBricks(source.settings); };
    // Bricks that resemble earlier ones depend on them.
    const bool isShareable = !isAlike(*work.previous) && !isAlike(*work.shown);
    if (const osg::ref_ptr<const MadeBricks> found = isShareable ? MadeBricks::find(source) : nullptr)
    {
        work.statistics = found->statistics;
        work.statistics.flattening = source.flattening;
        work.statistics.voxelization = 0.0;
        return found;
    }
    const osg::ref_ptr<MadeBricks> made = new MadeBricks;
    made->model = makeBricksOnCpu(source, work);
    if (!made->model) return nullptr;
    made->statistics = work.statistics;
    made->measureLayout = work.measureLayout;
    made->warning = work.warning;
    made->layout = std::move(*work.previous);
    if (isShareable) return MadeBricks::share(source, *made);
    return made;
}

/** Compute everything that drawing a set needs, so that the frame which shows it first takes no longer than others.
 * Sets of a source that moves are drawn with the distant occlusion of an earlier one. */
void CpuProducer::complete(const BrickSet& bricks, bool isMoving) const
{
    if (_computesNeighbors) bricks.getNeighbors();
    if (isMoving) return;
    for (const NearOcclusion near : {NearOcclusion::PICTURE, NearOcclusion::GRID})
        if (_computesDistantOcclusion[static_cast<std::size_t>(near)]) bricks.getDistantOcclusion(near);
}

/** Whether a source needs other bricks than the last one even if its triangles are the same. */
bool CpuProducer::hasOtherSettings(const LegoSource& source) const
{
    const std::lock_guard lock(_mutex);
    return !source.settings.givesSameBricks(_settings) || source.settings.view.show != _settings.view.show;
}

/** Begin a new set. @return its progress. */
std::shared_ptr<CpuProducer::Progress> CpuProducer::begin(const LegoSettings& settings)
{
    const std::lock_guard lock(_mutex);
    _settings = settings;
    _progress = std::make_shared<Progress>(LegoProgress{LegoProgress::Stage::CELLS});
    return _progress;
}

/** Print a warning, though not for each change of a source. */
void CpuProducer::warn(const std::string& warning)
{
    if (warning.empty()) return;
    {
        const std::lock_guard lock(_mutex);
        if (std::exchange(_warning, warning) == warning) return;
    }
    OSG_WARN << "osgLego: " << warning << std::endl;
}

LegoProgress CpuProducer::getProgress() const
{
    const std::shared_ptr<Job::Run> run = _job.getRun();
    if (!run || run->getOutcome() != Job::Outcome::NONE) return {};
    const std::lock_guard lock(_mutex);
    return _progress ? _progress->load() : LegoProgress{};
}

void CpuProducer::produceByLoad(const BrickModel& bricks, std::uint64_t revision)
{
    const auto createWork = [&]
    {
        return [this, model = osg::ref_ptr<const BrickModel>(&bricks), revision](const Job::Run& run,
                                                                                 std::string&) -> std::optional<Made>
        {
            LegoStatistics statistics;
            statistics.isStored = true;
            const osg::ref_ptr<const BrickSet> set =
                createSet(revision, *model, Show::LOAD, statistics, {}, [&run] { return run.isCancelled(); });
            if (!set) return std::nullopt;
            complete(*set, false);
            return Made{set, new MadeBricks};
        };
    };
    _job.cancel();
    _job.request(revision, false, createWork);
}

void CpuProducer::deliver(const Made& made)
{
    _store->deliver(*made.set);
    _shownBricks = made.bricks;
    if (!made.isDraft) _bricks = made.bricks;
}

void CpuProducer::update(unsigned int)
{
    _job.deliver();
}

void CpuProducer::finish(double seconds)
{
    if (const std::shared_ptr<Job::Run> run = _job.getRun()) run->wait(seconds);
    _job.deliver();
}

void CpuProducer::cancel()
{
    _job.cancel();
}

osg::ref_ptr<const BrickSet> CpuProducer::getBricks(const LegoSource& source, std::string& error)
{
    try
    {
        const std::shared_ptr<Job::Run> run = request(source, true, false).run;
        run->wait();
        error = run->getFailure();
        const Made* const made = run->getResult();
        return made ? made->set : nullptr;
    }
    catch (const std::bad_alloc&) // before the run, or while its failure is copied
    {
        error = OUT_OF_MEMORY;
        return nullptr;
    }
}

} // namespace osgLego
