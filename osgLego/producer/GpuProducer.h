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

/** The set that stands for the bricks of a source where their points are not on the CPU: its model, if it is ever asked
 * for, is made by voxelizeOnCpu(). */
osg::ref_ptr<const BrickSet> createGpuBrickSet(const LegoSource& source);

/** Makes brick sets by the passes on the GPU, in each context that draws them: in the frame that is being culled, ahead
 * of what is drawn in it, so that there is never anything to wait for.
 */
class GpuProducer : public BrickProducer
{
public:
    explicit GpuProducer(BrickStore& store) : _workspace(new PassWorkspace(store)) {}

    void produce(const LegoSource& source, osgUtil::CullVisitor& visitor, bool waits) override;
    void update(unsigned int frame) override;
    void cancel() override {}
    void resizeGLObjectBuffers(unsigned int maxSize) override;
    void releaseGLObjects(osg::State* state) override;

private:
    /** When a visitor queued the passes last. */
    struct LastCull
    {
        osg::observer_ptr<osgUtil::CullVisitor> visitor; // to tell it from a later one at the same address
        std::uint64_t revision = 0;
        unsigned int frame = 0;
    };

    ~GpuProducer() override = default;

    bool isFirstCullOfFrame(osgUtil::CullVisitor& visitor, const LegoSource& source);

    osg::ref_ptr<PassWorkspace> _workspace;
    std::mutex _mutex;
    osg::ref_ptr<LegolizationPasses> _passes;
    std::vector<LastCull> _lastCulls;
    unsigned int _idleFrames = 0;
    unsigned int _lastUpdate = 0;
};

} // namespace osgLego
