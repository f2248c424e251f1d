#include <osgLego/node/LegoPipeline.h>

#include <osgLego/BrickGeometry.h>
#include <osgLego/gl/GlRequirements.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/occlusion/GeometryBufferStage.h>

#include <algorithm>
#include <utility>

#include <osg/Notify>
#include <osg/Timer>

namespace osgLego
{

namespace
{

// After so many frames without work the passes are let go, and with them their textures; a frame that is still being
// drawn is never that far behind.
constexpr unsigned int IDLE_FRAMES = 8;

std::uint64_t makeRevision()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

} // namespace

LegoPipeline::LegoPipeline(const LegoSettings& settings) :
    _settings(settings), _store(new BrickStore), _lightProbe(new LightProbe)
{
}

osg::ref_ptr<const BrickNodes> LegoPipeline::getNodes() const
{
    const std::lock_guard lock(_mutex);
    if (!_nodes)
    {
        _nodes = new BrickNodes(*_store, _settings.look, _appearance, *_lightProbe);
        _nodes->getBound();
    }
    return _nodes;
}

void LegoPipeline::setSettings(const LegoSettings& settings)
{
    const std::lock_guard lock(_mutex);
    if (!settings.givesSameBricks(_settings)) _isDirty = true;
    const bool looksOtherwise = settings.look != _settings.look;
    _settings = settings;
    if (looksOtherwise) _nodes = nullptr;
}

LegoSettings LegoPipeline::getSettings() const
{
    const std::lock_guard lock(_mutex);
    return _settings;
}

void LegoPipeline::setAppearance(const BrickAppearance& appearance)
{
    const std::lock_guard lock(_mutex);
    if (appearance == _appearance) return;
    _appearance = appearance;
    _nodes = nullptr;
}

BrickAppearance LegoPipeline::getAppearance() const
{
    const std::lock_guard lock(_mutex);
    return _appearance;
}

void LegoPipeline::setLightProbe(const LightProbe& probe)
{
    const std::lock_guard lock(_mutex);
    _lightProbe = &probe;
    _nodes = nullptr;
}

osg::ref_ptr<const LightProbe> LegoPipeline::getLightProbe() const
{
    const std::lock_guard lock(_mutex);
    return _lightProbe;
}

void LegoPipeline::setTiming(bool timing)
{
    const std::lock_guard lock(_mutex);
    if (timing == _timing) return;
    _timing = timing;
    _isDirty = true;
}

bool LegoPipeline::getTiming() const
{
    const std::lock_guard lock(_mutex);
    return _timing;
}

void LegoPipeline::setReadBack(bool readBack)
{
    const std::lock_guard lock(_mutex);
    if (readBack == _readBack) return;
    _readBack = readBack;
    _isDirty = true;
}

bool LegoPipeline::getReadBack() const
{
    const std::lock_guard lock(_mutex);
    return _readBack;
}

void LegoPipeline::refresh(const osg::Node& source)
{
    const std::lock_guard lock(_mutex);
    const bool wasDirty = _isDirty.exchange(false);
    const SourceSignature& signature = _signatures.compute(source);
    if (!wasDirty && signature == _signature) return;

    const osg::Timer_t start = osg::Timer::instance()->tick();
    const osg::ref_ptr<const SceneTriangles> scene = SceneTriangles::create(source, _textures);
    osg::ref_ptr<LegoSource> lego;
    if (scene->getNumTriangles() > 0)
    {
        lego = new LegoSource;
        lego->revision = makeRevision();
        lego->settings = _settings;
        lego->triangles = GridTriangles::create(*scene, _settings);
        lego->flattening = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
        lego->timing = _timing;
        lego->readBack = _readBack;
    }
    _store->setSource(lego.get());
    if (_nodes)
    {
        _nodes->dirtyBound();
        _nodes->getBound(); // here, or several cull threads would compute it at once
    }
    _signature = signature;
    _isBoundDirty = true;
}

void LegoPipeline::releaseIdlePasses(unsigned int frame)
{
    const std::lock_guard lock(_mutex);
    // With several parents there are several updates in a frame.
    if (frame == std::exchange(_lastUpdate, frame)) return;
    if (!_passes || ++_idleFrames <= IDLE_FRAMES) return;
    _passes = nullptr;
    _lastCulls.clear();
    _store->releaseTextures();
}

bool LegoPipeline::cull(osgUtil::CullVisitor& visitor)
{
    const osg::ref_ptr<const LegoSource> source = _store->getSource();
    if (!source) return false;
    const osg::State& state = *visitor.getState();
    const osg::ref_ptr<ContextBricks> bricks = _store->getContext(state.getContextID());
    if (isHopeless(state, *bricks, *source)) return false;
    if (!bricks->isOf(*source)) cullPasses(visitor, *source);
    cullBricks(visitor, *source);
    return true;
}

void LegoPipeline::cullBricks(osgUtil::CullVisitor& visitor, const LegoSource& source)
{
    const osg::ref_ptr<const BrickNodes> nodes = getNodes();
    if (auto* stage = dynamic_cast<GeometryBufferStage*>(visitor.getCurrentRenderBin()->getStage()))
    {
        stage->noteBricks(source.triangles->getGrid().getPitch(), *visitor.getModelViewMatrix());
        nodes->getBufferNode().accept(visitor);
        return;
    }
    visitor.pushStateSet(getViewState(visitor));
    nodes->getFrameNode().accept(visitor);
    visitor.popStateSet();
}

/** What only this visit knows of the view: where the probe's light comes from, in the eye's coordinates. */
osg::ref_ptr<osg::StateSet> LegoPipeline::getViewState(osgUtil::CullVisitor& visitor)
{
    const std::lock_guard lock(_mutex);
    osg::ref_ptr<osg::StateSet>& state = _viewStates.find(visitor);
    if (!state) state = new osg::StateSet;
    state->getOrCreateUniform("eyeToWorld", osg::Uniform::FLOAT_MAT3)->set(toUniform(computeEyeToWorld(visitor)));
    return state;
}

bool LegoPipeline::isHopeless(const osg::State& state, ContextBricks& bricks, const LegoSource& source) const
{
    if (bricks.isHopeless() || bricks.getFailedRevision() == source.revision) return true;
    // There once the context has been current; in a first frame without it, the first pass finds out.
    const osg::GLExtensions* extensions = state.get<osg::GLExtensions>();
    const std::string missing = extensions ? GlRequirements::getMissingVersion(*extensions) : std::string();
    if (missing.empty()) return false;
    bricks.despair(state.getContextID(), missing);
    return true;
}

bool LegoPipeline::isFit(const osg::State& state) const
{
    const std::string& missing = GlRequirements::getMissing(state);
    if (!missing.empty()) _store->getContext(state.getContextID())->despair(state.getContextID(), missing);
    return missing.empty();
}

/** Whether a visitor has not been here before in its frame, as it is with a node of several parents. */
bool LegoPipeline::isFirstCullOfFrame(osgUtil::CullVisitor& visitor, const LegoSource& source)
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

void LegoPipeline::cullPasses(osgUtil::CullVisitor& visitor, const LegoSource& source)
{
    const std::lock_guard lock(_mutex);
    if (!isFirstCullOfFrame(visitor, source)) return;
    const PassPlan plan = PassPlan::create(source, GlRequirements::getRenderer(visitor.getState()->getContextID()));
    if (!_passes || _passes->getPlan() != plan) _passes = new LegolizationPasses(*_store, plan);
    _passes->cull(visitor);
    _idleFrames = 0;
}

osg::ref_ptr<osg::Node> LegoPipeline::getGeometryNode()
{
    const osg::ref_ptr<const BrickModel> model = _store->getModel();
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

osg::BoundingBoxd LegoPipeline::getBounds() const
{
    const osg::ref_ptr<const LegoSource> source = _store->getSource();
    return source ? source->triangles->getGrid().getBrickBounds() : osg::BoundingBoxd();
}

void LegoPipeline::resizeGLObjectBuffers(unsigned int maxSize)
{
    const std::lock_guard lock(_mutex);
    if (_nodes) _nodes->resizeGLObjectBuffers(maxSize);
    if (_passes) _passes->resizeGLObjectBuffers(maxSize);
}

void LegoPipeline::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    if (_nodes) _nodes->releaseGLObjects(state);
    _store->releaseGLObjects(state);
    if (_passes) _passes->releaseGLObjects(state);
    _lastCulls.clear();
}

} // namespace osgLego
