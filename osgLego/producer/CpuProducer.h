#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/layout/ModelBuilder.h>
#include <osgLego/producer/BrickProducer.h>
#include <osgLego/store/BrickStore.h>

#include <functional>
#include <memory>
#include <mutex>
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

    /** Wait for the model of a source, and return it; null if it could not be made. Cancels work on another source. */
    osg::ref_ptr<const BrickModel> getModel(const LegoSource& source);

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
