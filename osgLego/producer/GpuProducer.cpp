#include <osgLego/producer/GpuProducer.h>

#include <osgLego/gl/SharedGlObjects.h>
#include <osgLego/model/CpuBricks.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

namespace
{

// After this many frames without work, the passes and their textures are released. A frame that is still being drawn is
// never that far behind.
constexpr unsigned int IDLE_FRAMES = 8;

} // namespace

osg::ref_ptr<const BrickSet> createGpuBrickSet(const LegoSource& source)
{
    return new BrickSet(source.revision, source.triangles->getGrid(),
                        [kept = osg::ref_ptr<const LegoSource>(&source)]
                        {
                            CpuBricksWork work;
                            return makeBricksOnCpu(*kept, work);
                        });
}

GpuProducer::~GpuProducer()
{
    SharedGlObjects::get().removeUser(this);
}

void GpuProducer::produce(const LegoSource& source, osgUtil::CullVisitor& visitor, const FrameNeeds& needs)
{
    if (needs.neighbors) _workspace->wantNeighbors();
    const std::lock_guard lock(_mutex);
    if (!isFirstCullOfFrame(visitor, source)) return;
    if (_workspace->getWanted().source != &source) _workspace->setSource(source, *createGpuBrickSet(source));
    // The frame buffer object of a pass may be incomplete, which OSG does not try to mend.
    const std::uint64_t failed =
        _workspace->getStore().getContext(visitor.getState()->getContextID())->getFailedRevision();
    if (failed > _failedRevision)
    {
        _failedRevision = failed;
        _passes = nullptr;
    }
    const PassPlan plan = PassPlan::create(source);
    if (!_passes || _passes->getPlan() != plan) _passes = new LegolizationPasses(*_workspace, plan);
    SharedGlObjects::get().addUser(visitor.getState()->getContextID(), this);
    _passes->cull(visitor);
    _idleFrames = 0;
}

/** Whether this is the first cull of a source by a visitor in its frame; a node with several parents is culled several
 * times. */
bool GpuProducer::isFirstCullOfFrame(osgUtil::CullVisitor& visitor, const LegoSource& source)
{
    std::erase_if(_lastCulls, [](const LastCull& cull) { return !cull.visitor.valid(); });
    auto last = std::find_if(_lastCulls.begin(), _lastCulls.end(),
                             [&](const LastCull& cull) { return cull.visitor == &visitor; });
    if (last == _lastCulls.end()) last = _lastCulls.insert(last, LastCull{&visitor});
    const unsigned int frame = visitor.getTraversalNumber();
    if (last->revision == source.revision && last->frame == frame) return false;
    last->revision = source.revision;
    last->frame = frame;
    return true;
}

void GpuProducer::update(unsigned int frame)
{
    const std::lock_guard lock(_mutex);
    // A node with several parents is updated several times in a frame.
    if (frame == std::exchange(_lastUpdate, frame)) return;
    if (!_passes || ++_idleFrames <= IDLE_FRAMES) return;
    _passes = nullptr;
    SharedGlObjects::get().removeUser(this);
    _lastCulls.clear();
    _workspace->releaseTextures();
}

bool GpuProducer::isBusy() const
{
    const std::lock_guard lock(_mutex);
    return _passes.valid();
}

void GpuProducer::resizeGLObjectBuffers(unsigned int maxSize)
{
    const std::lock_guard lock(_mutex);
    if (_passes) _passes->resizeGLObjectBuffers(maxSize);
}

void GpuProducer::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    _workspace->releaseGLObjects(state);
    if (_passes) _passes->releaseGLObjects(state);
    _lastCulls.clear();
    SharedGlObjects::get().release(state, this);
}

} // namespace osgLego
