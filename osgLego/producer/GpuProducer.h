#pragma once

#include <osgLego/passes/PassWorkspace.h>
#include <osgLego/producer/BrickProducer.h>
#include <osgLego/producer/LegolizationPasses.h>

#include <cstdint>
#include <mutex>
#include <vector>

#include <osg/observer_ptr>
#include <osg/ref_ptr>

namespace osgLego
{

/** Create the brick set of a source whose points are not on the CPU. Its model is computed on demand, by
 * makeBricksOnCpu(). */
osg::ref_ptr<const BrickSet> createGpuBrickSet(const LegoSource& source);

/** Makes brick sets with the passes on the GPU, separately in each context that draws them. The passes are drawn in the
 * frame being culled, before its bricks, so that no frame ever has to wait.
 */
class GpuProducer : public BrickProducer
{
public:
    explicit GpuProducer(BrickStore& store) : _workspace(new PassWorkspace(store)) {}

    void produce(const LegoSource& source, osgUtil::CullVisitor& visitor, const FrameNeeds& needs) override;
    void update(unsigned int frame) override;
    bool isBusy() const override;
    void cancel() override { _workspace->clearSource(); }
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state) override;

private:
    /** The last time that a visitor queued the passes. */
    struct LastCull
    {
        osg::observer_ptr<osgUtil::CullVisitor> visitor; // detects a later visitor at the same address
        std::uint64_t revision = 0;
        unsigned int frame = 0;
    };

    ~GpuProducer() override;

    bool isFirstCullOfFrame(osgUtil::CullVisitor& visitor, const LegoSource& source);

    osg::ref_ptr<PassWorkspace> _workspace;
    mutable std::mutex _mutex;
    osg::ref_ptr<LegolizationPasses> _passes;
    std::vector<LastCull> _lastCulls;
    unsigned int _idleFrames = 0;
    unsigned int _lastUpdate = 0;
    std::uint64_t _failedRevision = 0; // the last one in any context, when the passes were created
};

} // namespace osgLego
