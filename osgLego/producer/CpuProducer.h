#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/model/ModelBuilder.h>
#include <osgLego/producer/BrickProducer.h>
#include <osgLego/store/BrickStore.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** Makes brick sets on the CPU (makeBricksOnCpu), in threads of oneTBB. It locks no context, and no frame waits unless
 * the caller asks for it. One set serves all contexts.
 */
class CpuProducer : public BrickProducer
{
public:
    /** @param announce called when a set is finished, in the thread that made it. */
    CpuProducer(BrickStore& store, std::function<void()> announce);

    void produce(const LegoSource& source, osgUtil::CullVisitor& visitor, bool waits) override;
    void update(unsigned int frame) override;
    void cancel() override;
    void resizeGLObjectBuffers(unsigned int) override {}
    void releaseGLObjects(osg::State*) override {}

    /** Wait for the bricks of a source, and return them. Cancels work on another source.
     * @return null, with one sentence in `error`, if they can't be made. */
    osg::ref_ptr<const BrickSet> getBricks(const LegoSource& source, std::string& error);

private:
    class Job;

    ~CpuProducer() override;

    std::shared_ptr<Job> start(const LegoSource& source, bool waits, bool& isNew);
    void retire();

    osg::ref_ptr<BrickStore> _store;
    std::function<void()> _announce;
    std::mutex _mutex;
    bool _hasGivenUp = false;                   // whether the job before the present one was given up
    PreviousLayout _layout;                     // of the last job that has ended
    std::shared_ptr<Job> _job;                  // of the last source requested
    std::vector<std::shared_ptr<Job>> _retired; // cancelled, but possibly still running
};

} // namespace osgLego
