#include <osgLego/node/LegoPipeline.h>

#include <osgLego/gl/GlRequirements.h>

#include <algorithm>
#include <utility>

namespace osgLego
{

LegoPipeline::LegoPipeline(const LegoSettings& settings, const SettingsPalette& palette) :
    _store(new BrickStore), _display(*_store),
    _cpuProducer(new CpuProducer(*_store, [announcement = _announcement] { (*announcement)(); })),
    _gpuProducer(new GpuProducer(*_store)),
    _building(new BuildingProducer(*_store, [announcement = _announcement] { (*announcement)(); })),
    _query(*_store, *_cpuProducer)
{
    setSettings(settings, palette);
}

void LegoPipeline::setSettings(const LegoSettings& settings, const SettingsPalette& palette)
{
    _store->retryPrograms();
    const bool showsStoredAgain = _source.setSettings(settings, palette);
    _display.setLook(settings.view.look, settings.view.drawing);
    setProgress(settings.view.progress);
    const osg::ref_ptr<const BrickModel> stored = showsStoredAgain ? _source.getStored() : nullptr;
    if (stored) showStored(*stored);
}

LegoSettings LegoPipeline::getSettings() const
{
    LegoSettings settings = _source.getSettings();
    settings.view.progress = _store->getState().progress;
    return settings;
}

void LegoPipeline::setProgress(double progress)
{
    const std::lock_guard lock(_mutex);
    BuildingState state = _store->getState();
    state.progress = progress;
    _store->setState(state);
}

void LegoPipeline::setNumNewParts(std::size_t count)
{
    const std::lock_guard lock(_mutex);
    BuildingState state = _store->getState();
    state.numNew = count;
    _store->setState(state);
}

std::string LegoPipeline::setHighlightedParts(std::span<const std::size_t> parts, const PartHighlight::Color& color)
{
    osg::ref_ptr<const PartHighlight> highlight;
    if (!parts.empty())
    {
        osg::ref_ptr<const BrickModel> model = getShownModel();
        if (!model) model = getModel();
        if (!model) return "there are no bricks to highlight; expected a source with triangles, or stored bricks";
        const std::size_t count = model->getParts().empty() ? model->getBricks().size() : model->getParts().size();
        const std::size_t last = *std::ranges::max_element(parts);
        if (last >= count)
            return "bad index " + std::to_string(last) + " of a highlighted part; expected 0 to " +
                   std::to_string(count - 1);
        highlight = new PartHighlight(*model, parts, color);
    }
    _store->setHighlight(highlight);
    return {};
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
    _store->retryPrograms();
    if (!_source.setStored(bricks)) return;
    if (bricks)
        showStored(*bricks);
    else
        _cpuProducer->cancel();
}

void LegoPipeline::showStored(const BrickModel& bricks)
{
    const BrickSource::StoredRevisions revisions = _source.numberStored(bricks);
    _cpuProducer->cancel();
    _gpuProducer->cancel();
    _store->clear(revisions.own);
    LegoStatistics statistics;
    statistics.isStored = true;
    const osg::ref_ptr<const BrickSet> set = new BrickSet(revisions.own, bricks, statistics);
    _store->deliver(*set);
    if (revisions.byLoad != 0) _cpuProducer->produceByLoad(bricks, revisions.byLoad);
    _display.dirtyBound();
}

LegoPipeline::Frame::Frame(const osg::NodeVisitor& visitor) :
    viewer(visitor.getFrameStamp()), number(visitor.getTraversalNumber())
{
}

void LegoPipeline::refresh(const osg::Node& source)
{
    const std::lock_guard lock(_mutex);
    look(source);
}

void LegoPipeline::refreshInTime(const osg::Node& source)
{
    const std::lock_guard lock(_mutex);
    lookInTime(source);
}

void LegoPipeline::refreshInFrame(const osg::Node& source, const osg::NodeVisitor& visitor)
{
    const std::lock_guard lock(_mutex);
    const Frame frame(visitor);
    const bool wasChecked = std::exchange(_lastFrame, frame) == frame;
    if (!wasChecked || _source.isDirty()) lookInTime(source);
}

/** The same as look(), but sources are not flattened in vain that will have changed before their turn comes. */
void LegoPipeline::lookInTime(const osg::Node& source)
{
    if (_waiting || _source.isDirty() || !_cpuProducer->isRefusing()) look(source);
}

/** Check the source; called with the lock. */
void LegoPipeline::look(const osg::Node& source)
{
    if (!_source.look(source)) return;
    if (const osg::ref_ptr<const LegoSource> lego = _source.getSource())
        _store->expect(lego->revision, lego->triangles->getGrid());
    else
    {
        _cpuProducer->cancel();
        _gpuProducer->cancel();
        _store->clear(_source.getLastRevision());
    }
    // Here, because picking and culling may come before the next update.
    _display.dirtyBound();
}

bool LegoPipeline::update(const osg::NodeVisitor& visitor)
{
    _cpuProducer->update(visitor.getTraversalNumber());
    _gpuProducer->update(visitor.getTraversalNumber());
    _building->update();
    const osg::BoundingBoxd bounds = getBounds();
    const std::lock_guard lock(_mutex);
    _lastFrame = Frame(visitor);
    if (bounds == _lastBounds) return false;
    _lastBounds = bounds;
    _display.dirtyBound();
    return true;
}

bool LegoPipeline::isBusy()
{
    if (isDirty() || _cpuProducer->isBusy() || _gpuProducer->isBusy() || _building->isBusy()) return true;
    if (!_waiting && _store->isSettling()) return true;
    const osg::BoundingBoxd bounds = getBounds();
    const std::lock_guard lock(_mutex);
    return bounds != _lastBounds;
}

bool LegoPipeline::cull(osgUtil::CullVisitor& visitor)
{
    const osg::ref_ptr<const LegoSource> source = getSource();
    const std::uint64_t revision = source ? source->revision : getRevision();
    if (revision == 0)
    {
        _source.warnOfObstacle();
        return false;
    }
    const osg::State& state = *visitor.getState();
    const osg::ref_ptr<ContextBricks> bricks = _store->getContext(state.getContextID());
    bricks->setAwaited(_waiting);
    if (mustDrawSource(state, *bricks, revision)) return false;
    bool isLate = false;
    if (source && !bricks->isOf(revision))
    {
        isLate = produce(*source, *bricks, visitor);
        if (mustDrawSource(state, *bricks, revision)) return false;
        if (isLate && !hasBricks(*bricks)) return source->settings.view.meanwhile == Meanwhile::NOTHING;
    }
    if (_waiting && !source) _cpuProducer->finish(_waitingLimit);
    prepareBuilding(isLate ? nullptr : source.get());
    _display.cull(visitor);
    return true;
}

/** Have the bricks of a source made.
 * @return whether the CPU has not finished them in time for this frame. */
bool LegoPipeline::produce(const LegoSource& source, const ContextBricks& bricks, osgUtil::CullVisitor& visitor)
{
    BrickProducer& producer = chooseProducer(source.settings, visitor.getState()->getContextID());
    producer.produce(source, visitor, findNeeds(source.settings.view.meanwhile, bricks, visitor));
    if (&producer != _cpuProducer.get()) return false;
    const osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    // Picking may have made a set without points.
    return !newest || !newest->hasPoints() || newest->getRevision() != source.revision;
}

FrameNeeds LegoPipeline::findNeeds(Meanwhile meanwhile, const ContextBricks& bricks,
                                   osgUtil::CullVisitor& visitor) const
{
    const bool isDraftEnough = !_waiting && meanwhile == Meanwhile::DRAFT;
    const bool mustWait = _waiting || ((isDraftEnough || meanwhile == Meanwhile::WAIT) && !hasBricks(bricks));
    FrameNeeds needs{mustWait ? _waitingLimit.load() : 0.0, isDraftEnough};
    _display.addOcclusion(visitor, needs);
    return needs;
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

/** Whether there are bricks to show, of whatever source. */
bool LegoPipeline::hasBricks(const ContextBricks& bricks) const
{
    const osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    return !bricks.isEmpty() || (newest && newest->hasPoints());
}

/** Request the building set if not all parts are shown alike. @param source null for stored bricks, and for those of
 * an earlier source. */
void LegoPipeline::prepareBuilding(const LegoSource* source)
{
    if (_store->getState().isWhole()) return;
    osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    // Passes deliver their bricks only when they have been drawn.
    const bool isOnItsWay = source && !(newest && newest->getRevision() == source->revision);
    if (_waiting && isOnItsWay) newest = createGpuBrickSet(*source);
    if (newest) _building->produce(*newest, _waiting ? _waitingLimit.load() : 0.0);
}

bool LegoPipeline::mustDrawSource(const osg::State& state, ContextBricks& bricks, std::uint64_t revision) const
{
    if (bricks.isUnsupported() || bricks.lacksPrograms() || bricks.getFailedRevision() == revision) return true;
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

std::string LegoPipeline::getObstacle() const
{
    const std::string failure = _query.getFailure(_source.getLastRevision());
    return failure.empty() ? _source.getObstacle() : failure;
}

osg::ref_ptr<const BrickModel> LegoPipeline::getShownModel() const
{
    const osg::ref_ptr<const BrickSet> newest = _store->getBricks();
    return newest && newest->hasPoints() ? newest->getModel() : nullptr;
}

osg::ref_ptr<const BrickModel> LegoPipeline::getModel()
{
    if (osg::ref_ptr<const BrickModel> stored = getStoredBricks()) return stored;
    const osg::ref_ptr<const LegoSource> source = getSource();
    return source ? _query.getModel(*source) : nullptr;
}

osg::BoundingBoxd LegoPipeline::getBounds() const
{
    const osg::BoundingBoxd bounds = _store->getBounds();
    const osg::Matrixd toNode = getToNode();
    if (!bounds.valid() || toNode.isIdentity()) return bounds;
    osg::BoundingBoxd moved;
    for (unsigned int corner = 0; corner < 8; ++corner)
        moved.expandBy(bounds.corner(corner) * toNode);
    return moved;
}

std::optional<Meanwhile> LegoPipeline::getMeanwhile() const
{
    const osg::ref_ptr<const LegoSource> source = getSource();
    if (!source || _store->getBricks()) return std::nullopt;
    const Meanwhile meanwhile = source->settings.view.meanwhile;
    const bool isWaited = meanwhile == Meanwhile::WAIT || meanwhile == Meanwhile::DRAFT;
    return isWaited ? std::nullopt : std::optional(meanwhile);
}

void LegoPipeline::prepareForPicking()
{
    const osg::ref_ptr<const LegoSource> source = getSource();
    if (source) _query.prepareForPicking(*source);
    prepareBuilding(source);
}

osg::ref_ptr<osg::Node> LegoPipeline::getGeometryNode()
{
    const osg::ref_ptr<const BrickModel> model = getModel();
    return model ? _query.getGeometryNode(*model) : nullptr;
}

void LegoPipeline::resizeGLObjectBuffers(unsigned int maxSize)
{
    _query.resizeGLObjectBuffers(maxSize);
    _display.resizeGLObjectBuffers(maxSize);
    _gpuProducer->resizeGLObjectBuffers(maxSize);
}

void LegoPipeline::releaseGLObjects(osg::State* state)
{
    _query.releaseGLObjects(state);
    _display.releaseGLObjects(state);
    _store->releaseGLObjects(state);
    _gpuProducer->releaseGLObjects(state);
}

} // namespace osgLego
