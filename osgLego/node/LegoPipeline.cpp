#include <osgLego/node/LegoPipeline.h>

#include <osgLego/BrickGeometry.h>
#include <osgLego/gl/GlRequirements.h>

#include <utility>

#include <osg/Notify>

namespace osgLego
{

LegoPipeline::LegoPipeline(const LegoSettings& settings) :
    _store(new BrickStore), _display(*_store),
    _cpuProducer(new CpuProducer(*_store, [announcement = _announcement] { (*announcement)(); })),
    _gpuProducer(new GpuProducer(*_store)),
    _building(new BuildingProducer(*_store, [announcement = _announcement] { (*announcement)(); }))
{
    setSettings(settings);
}

void LegoPipeline::setSettings(const LegoSettings& settings)
{
    osg::ref_ptr<const BrickModel> stored;
    {
        const std::lock_guard lock(_mutex);
        const bool isShownAlike = settings.view.show == _request.settings.view.show;
        if (!settings.givesSameBricks(_request.settings) || !isShownAlike) _isDirty = true;
        if (!isShownAlike) stored = _storedBricks;
        _request.settings = settings;
        _display.setLook(settings.view.look, settings.view.drawing);
        applyProgress();
    }
    if (stored) showStored(*stored);
}

void LegoPipeline::setProgress(double progress)
{
    const std::lock_guard lock(_mutex);
    _request.settings.view.progress = progress;
    applyProgress();
}

/** Show the parts that the settings ask for. The caller holds the mutex. */
void LegoPipeline::applyProgress()
{
    BuildingState state = _store->getState();
    state.progress = _request.settings.view.progress;
    _store->setState(state);
}

void LegoPipeline::setNumNewParts(std::size_t count)
{
    const std::lock_guard lock(_mutex);
    BuildingState state = _store->getState();
    state.numNew = count;
    _store->setState(state);
}

LegoSettings LegoPipeline::getSettings() const
{
    const std::lock_guard lock(_mutex);
    return _request.settings;
}

void LegoPipeline::setTiming(bool timing)
{
    const std::lock_guard lock(_mutex);
    if (std::exchange(_request.timing, timing) != timing) _isDirty = true;
}

bool LegoPipeline::getTiming() const
{
    const std::lock_guard lock(_mutex);
    return _request.timing;
}

void LegoPipeline::setReadBack(bool readBack)
{
    const std::lock_guard lock(_mutex);
    if (std::exchange(_request.readBack, readBack) != readBack) _isDirty = true;
}

bool LegoPipeline::getReadBack() const
{
    const std::lock_guard lock(_mutex);
    return _request.readBack;
}

void LegoPipeline::setAnnouncement(std::function<void()> announcement)
{
    const std::lock_guard lock(_announcement->mutex);
    _announcement->call = std::move(announcement);
}

void LegoPipeline::Announcement::operator()()
{
    const std::lock_guard lock(mutex);
    if (call) call();
}

void LegoPipeline::setStoredBricks(const BrickModel* bricks)
{
    {
        const std::lock_guard lock(_mutex);
        if (bricks == _storedBricks) return;
        _storedBricks = bricks;
        if (!bricks) _watch.drop();
    }
    _isDirty = !bricks;
    if (bricks)
        showStored(*bricks);
    else
        _cpuProducer->cancel();
}

void LegoPipeline::showStored(const BrickModel& bricks)
{
    std::uint64_t revision = 0;
    std::uint64_t revisionByLoad = 0;
    {
        const std::lock_guard lock(_mutex);
        revision = _watch.drop();
        // The parts have their own colours until those for their load have been computed.
        if (_request.settings.view.show == Show::LOAD && !bricks.getParts().empty()) revisionByLoad = _watch.drop();
    }
    _cpuProducer->cancel();
    _gpuProducer->cancel();
    _store->clear(revision);
    LegoStatistics statistics;
    statistics.isStored = true;
    const osg::ref_ptr<const BrickSet> set = new BrickSet(revision, bricks, statistics);
    _store->deliver(*set);
    if (revisionByLoad != 0) _cpuProducer->produceByLoad(bricks, revisionByLoad);
    _display.dirtyBound();
}

osg::ref_ptr<const BrickModel> LegoPipeline::getStoredBricks() const
{
    const std::lock_guard lock(_mutex);
    return _storedBricks;
}

void LegoPipeline::refresh(const osg::Node& source)
{
    const std::lock_guard lock(_mutex);
    if (_storedBricks)
    {
        _isDirty = false;
        return;
    }
    if (!_watch.look(source, _request, _isDirty.exchange(false))) return;
    if (const osg::ref_ptr<const LegoSource> lego = _watch.getSource())
        _store->expect(lego->revision, lego->triangles->getGrid());
    else
    {
        _cpuProducer->cancel();
        _gpuProducer->cancel();
        _store->clear(_watch.getRevision());
    }
    // Here, because picking and culling may come before the next update.
    _display.dirtyBound();
}

bool LegoPipeline::update(unsigned int frame)
{
    _cpuProducer->update(frame);
    _gpuProducer->update(frame);
    const osg::BoundingBoxd bounds = getBounds();
    const std::lock_guard lock(_mutex);
    if (bounds == _lastBounds) return false;
    _lastBounds = bounds;
    _display.dirtyBound();
    return true;
}

bool LegoPipeline::cull(osgUtil::CullVisitor& visitor)
{
    const osg::ref_ptr<const LegoSource> source = getSource();
    const std::uint64_t revision = source ? source->revision : getRevision();
    if (revision == 0)
    {
        warnOfObstacle();
        return false;
    }
    const osg::State& state = *visitor.getState();
    const osg::ref_ptr<ContextBricks> bricks = _store->getContext(state.getContextID());
    if (mustDrawSource(state, *bricks, revision)) return false;
    if (source && !bricks->isOf(revision))
    {
        chooseProducer(source->settings, state.getContextID()).produce(*source, visitor, mustWait(*bricks));
        if (mustDrawSource(state, *bricks, revision)) return false;
    }
    if (_waiting && !source) _cpuProducer->finish();
    prepareBuilding(source);
    _display.cull(visitor);
    return true;
}

/** Choose the device that makes the bricks. With Device::AUTO, this is the CPU while the renderer of a context is
 * unknown, since any context can show bricks from the CPU. */
BrickProducer& LegoPipeline::chooseProducer(const LegoSettings& settings, unsigned int contextID) const
{
    if (settings.voxelization.device == Device::CPU || settings.needsCpu()) return *_cpuProducer;
    if (settings.voxelization.device == Device::GPU || settings.voxelization.method != VoxelizationMethod::EXACT)
        return *_gpuProducer;
    if (GlRequirements::getRenderer(contextID) == Renderer::HARDWARE) return *_gpuProducer;
    return *_cpuProducer;
}

/** Whether a frame must wait for its bricks: on request, or because there are no others to show. */
bool LegoPipeline::mustWait(const ContextBricks& bricks) const
{
    if (_waiting) return true;
    const osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    return bricks.isEmpty() && !(newest && newest->hasPoints());
}

/** Request the building set if not all parts are shown alike. @param source null for stored bricks. */
void LegoPipeline::prepareBuilding(const LegoSource* source)
{
    if (_store->getState().isWhole()) return;
    osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    // Passes deliver their bricks only when they have been drawn.
    const bool isOnItsWay = source && !(newest && newest->getRevision() == source->revision);
    if (_waiting && isOnItsWay) newest = createGpuBrickSet(*source);
    if (newest) _building->produce(*newest, _waiting);
}

bool LegoPipeline::mustDrawSource(const osg::State& state, ContextBricks& bricks, std::uint64_t revision) const
{
    if (bricks.isUnsupported() || bricks.getFailedRevision() == revision) return true;
    // Null until the context has been current; in such a first frame, drawing checks the requirements.
    const osg::GLExtensions* extensions = state.get<osg::GLExtensions>();
    const std::string missing = extensions ? GlRequirements::getMissingVersion(*extensions) : std::string();
    if (missing.empty()) return false;
    bricks.markUnsupported(state.getContextID(), missing);
    return true;
}

bool LegoPipeline::isFit(const osg::State& state) const
{
    const std::string& missing = GlRequirements::getMissing(state);
    if (!missing.empty()) _store->getContext(state.getContextID())->markUnsupported(state.getContextID(), missing);
    return missing.empty();
}

std::uint64_t LegoPipeline::getRevision() const
{
    const std::lock_guard lock(_mutex);
    return _storedBricks || _watch.getSource() ? _watch.getRevision() : 0;
}

osg::ref_ptr<const LegoSource> LegoPipeline::getSource() const
{
    const std::lock_guard lock(_mutex);
    return _watch.getSource();
}

std::string LegoPipeline::getObstacle() const
{
    const std::lock_guard lock(_mutex);
    return _failedRevision != 0 && _failedRevision == _watch.getRevision() ? _failure : _watch.getObstacle();
}

/** Print the obstacle, once for each. */
void LegoPipeline::warnOfObstacle()
{
    const std::lock_guard lock(_mutex);
    const std::string& obstacle = _watch.getObstacle();
    if (std::exchange(_printedObstacle, obstacle) != obstacle && !obstacle.empty())
        OSG_WARN << "osgLego: " << obstacle << "; the source is drawn instead of bricks" << std::endl;
}

osg::ref_ptr<const BrickModel> LegoPipeline::getModel()
{
    if (osg::ref_ptr<const BrickModel> stored = getStoredBricks()) return stored;
    const osg::ref_ptr<const LegoSource> source = getSource();
    if (!source) return nullptr;
    const osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    if (newest && newest->getRevision() == source->revision) return newest->getModel();
    const osg::ref_ptr<const BrickSet> made = makeOnCpu(*source);
    return made ? made->getModel() : nullptr;
}

/** Wait for the bricks of a source. @return null, with the reason in getObstacle(), if they can't be made. */
osg::ref_ptr<const BrickSet> LegoPipeline::makeOnCpu(const LegoSource& source)
{
    std::string error;
    const osg::ref_ptr<const BrickSet> bricks = _cpuProducer->getBricks(source, error);
    const std::lock_guard lock(_mutex);
    _failedRevision = bricks ? 0 : source.revision;
    _failure = error;
    return bricks;
}

void LegoPipeline::prepareForPicking()
{
    const osg::ref_ptr<const LegoSource> source = getSource();
    if (source) preparePickedBricks(*source);
    prepareBuilding(source);
}

void LegoPipeline::preparePickedBricks(const LegoSource& source)
{
    const osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    // A set that is shown is picked until the next set is shown. A set made only for picking must match the source.
    const bool isShown = newest && (newest->hasPoints() || newest->getRevision() == source.revision);
    if (isShown) return;
    // Bricks that the GPU can't make take long to make again, so those made for picking are shown, too.
    const osg::ref_ptr<const BrickSet> bricks =
        source.settings.needsCpu() ? makeOnCpu(source) : createGpuBrickSet(source);
    if (bricks) _store->deliver(*bricks);
}

osg::ref_ptr<osg::Node> LegoPipeline::getGeometryNode()
{
    const osg::ref_ptr<const BrickModel> model = getModel();
    if (!model) return nullptr;
    const std::lock_guard lock(_mutex);
    if (model != _geometryModel)
    {
        _geometryModel = model;
        _geometryNode = new osg::Geode;
        _geometryNode->addDrawable(createBrickGeometry(*model));
    }
    return _geometryNode;
}

void LegoPipeline::resizeGLObjectBuffers(unsigned int maxSize)
{
    if (const std::lock_guard lock(_mutex); _geometryNode) _geometryNode->resizeGLObjectBuffers(maxSize);
    _display.resizeGLObjectBuffers(maxSize);
    _gpuProducer->resizeGLObjectBuffers(maxSize);
}

void LegoPipeline::releaseGLObjects(osg::State* state)
{
    if (const std::lock_guard lock(_mutex); _geometryNode) _geometryNode->releaseGLObjects(state);
    _display.releaseGLObjects(state);
    _store->releaseGLObjects(state);
    _gpuProducer->releaseGLObjects(state);
}

} // namespace osgLego
