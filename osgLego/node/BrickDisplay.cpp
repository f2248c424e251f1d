#include <osgLego/node/BrickDisplay.h>

#include <osgLego/polygonization/BrickStage.h>
#include <osgLego/polygonization/ViewStates.h>

namespace osgLego
{

BrickDisplay::BrickDisplay(BrickStore& store) : _store(&store), _lightProbe(new LightProbe) {}

osg::ref_ptr<const BrickNodes> BrickDisplay::getNodes() const
{
    const BuildingState state = _store->getState();
    const std::lock_guard lock(_mutex);
    BrickNodes::Kind kind;
    kind.isPartial = !state.isWhole() && _store->getBuilding();
    kind.hasLines = _appearance.outline > 0.0 || (kind.isPartial && state.numNew > 0);
    osg::ref_ptr<const BrickNodes>& nodes = _nodes[(kind.isPartial ? 1u : 0u) + (kind.hasLines ? 2u : 0u)];
    if (!nodes)
    {
        nodes = new BrickNodes(*_store, _look, _drawing, _appearance, *_lightProbe, kind);
        nodes->getBound();
    }
    return nodes;
}

void BrickDisplay::setLook(Look look, Drawing drawing)
{
    const std::lock_guard lock(_mutex);
    if (look == _look && drawing == _drawing) return;
    _look = look;
    _drawing = drawing;
    dropNodes();
}

void BrickDisplay::setAppearance(const BrickAppearance& appearance)
{
    const std::lock_guard lock(_mutex);
    if (appearance == _appearance) return;
    _appearance = appearance;
    dropNodes();
}

BrickAppearance BrickDisplay::getAppearance() const
{
    const std::lock_guard lock(_mutex);
    return _appearance;
}

void BrickDisplay::setLightProbe(const LightProbe& probe)
{
    const std::lock_guard lock(_mutex);
    _lightProbe = &probe;
    dropNodes();
}

osg::ref_ptr<const LightProbe> BrickDisplay::getLightProbe() const
{
    const std::lock_guard lock(_mutex);
    return _lightProbe;
}

void BrickDisplay::addOcclusion(osgUtil::CullVisitor& visitor, FrameNeeds& needs) const
{
    const BrickStage* stage = BrickStage::find(visitor);
    const bool mayBeDistant = !stage || stage->hasDistantOcclusion();
    const std::lock_guard lock(_mutex);
    if (_look == Look::PLAIN || _appearance.occlusion == BrickOcclusion::OFF) return;
    needs.neighbors = _appearance.occlusion != BrickOcclusion::SCREEN;
    if (needs.neighbors && mayBeDistant && _appearance.distantOcclusion) needs.distantOcclusion = NearOcclusion::GRID;
    if (!needs.neighbors && mayBeDistant && stage) needs.distantOcclusion = NearOcclusion::PICTURE;
}

void BrickDisplay::cull(osgUtil::CullVisitor& visitor)
{
    const osg::ref_ptr<const BrickNodes> nodes = getNodes();
    if (BrickStage* stage = BrickStage::find(visitor))
    {
        stage->noteBricks(_store->getPitch(), *visitor.getModelViewMatrix());
        nodes->cullForBuffer(stage->hasDistantOcclusion(), visitor);
        return;
    }
    const osg::ref_ptr<osg::StateSet> view = ViewStates::get().find(visitor);
    visitor.pushStateSet(view);
    nodes->cullForFrame(visitor);
    visitor.popStateSet();
}

void BrickDisplay::dirtyBound()
{
    const std::lock_guard lock(_mutex);
    for (const osg::ref_ptr<const BrickNodes>& nodes : _nodes)
    {
        if (!nodes) continue;
        nodes->dirtyBound();
        nodes->getBound(); // computed here, so that cull threads don't compute it concurrently
    }
}

void BrickDisplay::resizeGLObjectBuffers(unsigned int maxSize)
{
    const std::lock_guard lock(_mutex);
    for (const osg::ref_ptr<const BrickNodes>& nodes : _nodes)
        if (nodes) nodes->resizeGLObjectBuffers(maxSize);
}

void BrickDisplay::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (const osg::ref_ptr<const BrickNodes>& nodes : _nodes)
        if (nodes) nodes->releaseGLObjects(state);
}

} // namespace osgLego
