#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/producer/BrickProducer.h>
#include <osgLego/store/BrickStore.h>

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

/** Makes brick sets on the CPU (voxelizeOnCpu), on threads of oneTBB: no context is locked and no frame waits, unless
 * the caller asks for it. One set serves all contexts.
 */
class CpuProducer : public BrickProducer
{
public:
    /** @param announce called after each set is finished, by the thread that finished it. */
    CpuProducer(BrickStore& store, std::function<void()> announce);

    void produce(const LegoSource& source, osgUtil::CullVisitor& visitor, bool waits) override;
    void update(unsigned int frame) override;
    void cancel() override;
    void resizeGLObjectBuffers(unsigned int) override {}
    void releaseGLObjects(osg::State*) override {}

    /** The model of a source, for which this waits. Work on another source is given up. */
    osg::ref_ptr<const BrickModel> getModel(const LegoSource& source);

private:
    class Job;

    ~CpuProducer() override;

    std::shared_ptr<Job> start(const LegoSource& source);
    void retire();

    osg::ref_ptr<BrickStore> _store;
    std::function<void()> _announce;
    std::mutex _mutex;
    std::shared_ptr<Job> _job;                  // of the source asked for last
    std::vector<std::shared_ptr<Job>> _retired; // given up, and perhaps still running
};

} // namespace osgLego
