#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/LegoProgress.h>
#include <osgLego/data/BrickSet.h>
#include <osgLego/model/CpuBricks.h>
#include <osgLego/model/ModelBuilder.h>
#include <osgLego/producer/BackgroundJob.h>
#include <osgLego/producer/BrickProducer.h>
#include <osgLego/producer/MadeBricks.h>
#include <osgLego/producer/MotionPace.h>
#include <osgLego/store/BrickStore.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <osg/ref_ptr>

namespace osgLego
{

/** Makes brick sets on the CPU (makeBricksOnCpu), in the background. It locks no context, and no frame waits unless the
 * caller asks for it. One set serves all contexts.
 *
 * A source with other settings always cancels work in progress, so that settings take effect at once. A source that has
 * only changed does so unless the work before was cancelled, so that continual changes are shown at intervals.
 *
 * If no frame waits for them, parts that take longer than Effort::INSTANT follow a draft laid with that effort
 * (LegoSource::getDraftRevision()). While a source moves, drafts are laid greedily, whatever the effort: each change
 * cancels the work behind the draft before it, which therefore begins only when the source has rested for a moment.
 * Sets then rest between each other, so that time is left for drawing them (MotionPace).
 *
 * With Show::LOAD, the parts of a set have colours for the load on their joints (colorByLoad). If the loads can't be
 * computed, the parts keep their colours, and a warning says why.
 */
class CpuProducer : public BrickProducer
{
public:
    /** @param announce called when a set is finished, in the thread that made it. */
    CpuProducer(BrickStore& store, std::function<void()> announce);

    void produce(const LegoSource& source, osgUtil::CullVisitor& visitor, const FrameNeeds& needs) override;
    void update(unsigned int frame) override;
    bool isBusy() const override { return _job.isBusy(); }
    void cancel() override;
    void resizeGLObjectBuffers(unsigned int) override {}
    void releaseGLObjects(osg::State*) override {}

    /** Whether a source that has only changed would have to wait, since the last one has no bricks yet. Counts as such
     * a change. */
    bool isRefusing() { return _job.isRefusing(); }

    /** Wait for the bricks of a source, and return them. Cancels work on another source.
     * @return null, with one sentence in `error`, if they can't be made. */
    osg::ref_ptr<const BrickSet> getBricks(const LegoSource& source, std::string& error);

    /** Begin to make the set of stored bricks with Show::LOAD. Cancels work on others. @param revision of the set. */
    void produceByLoad(const BrickModel& bricks, std::uint64_t revision);
    /** Wait for the set in progress, if there is one, and deliver it. */
    void finish(double seconds = BackgroundTask::FOREVER);

    /** The progress of the set in progress. */
    LegoProgress getProgress() const;

    /** The number of sets that were made, that failed, and that were cancelled. */
    auto getCounts() const { return _job.getCounts(); }

private:
    struct Made
    {
        osg::ref_ptr<const BrickSet> set;
        osg::ref_ptr<const MadeBricks> bricks;
        bool isDraft = false;
    };
    using Job = BackgroundJob<Made>;
    using Progress = std::atomic<LegoProgress>;
    static_assert(alignof(LegoProgress) == sizeof(LegoProgress), "Clang needs libatomic for smaller alignments");

    ~CpuProducer() override = default;

    std::shared_ptr<Progress> begin(const LegoSettings& settings);
    bool hasOtherSettings(const LegoSource& source) const;
    Job::Request request(const LegoSource& source, bool isUrgent, bool isAwaited);
    std::optional<Made> make(const LegoSource& source, CpuBricksWork& work, bool isMoving, std::string& error);
    static osg::ref_ptr<const MadeBricks> makeOrFind(const LegoSource& source, CpuBricksWork& work);
    void complete(const BrickSet& bricks, bool isMoving) const;
    void warn(const std::string& warning);
    void deliver(const Made& made);

    osg::ref_ptr<BrickStore> _store;
    mutable std::mutex _mutex;           // guards the next three
    std::shared_ptr<Progress> _progress; // of the last set; the work has it, too, and may outlast its request
    LegoSettings _settings;              // of the last set
    std::string _warning;                // the last one that was printed
    // Those of the last set but drafts, and of the last set; guarded by the job, whose calls alone use them.
    osg::ref_ptr<const MadeBricks> _bricks = new MadeBricks;
    osg::ref_ptr<const MadeBricks> _shownBricks = _bricks;
    MotionPace _pace;
    // Since a frame has needed them.
    std::atomic<bool> _computesNeighbors{false};
    std::array<std::atomic<bool>, 2> _computesDistantOcclusion{}; // by NearOcclusion
    Job _job;
};

} // namespace osgLego
