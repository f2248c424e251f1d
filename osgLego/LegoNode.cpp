#include <osgLego/LegoNode.h>

#include <osgLego/flattening/SourceVisitor.h>
#include <osgLego/gl/GlRequirements.h>
#include <osgLego/node/BrickFileWriter.h>
#include <osgLego/node/LegoPipeline.h>

#include <mutex>
#include <optional>
#include <utility>

#include <osg/Notify>
#include <osgUtil/CullVisitor>
#include <osgUtil/GLObjectsVisitor>

namespace osgLego
{

LegoNode::LegoNode() : LegoNode(LegoSettings()) {}

LegoNode::LegoNode(const LegoSettings& settings) : _pipeline(new LegoPipeline(LegoSettings(), {}))
{
    BrickFileWriter::install();
    setSettings(settings);
    setRequiresUpdate(true);
}

LegoNode::LegoNode(const LegoNode& node, const osg::CopyOp& copyop) :
    osg::Group(node, copyop), _pipeline(new LegoPipeline(node.getSettings(), node._pipeline->getPalette()))
{
    setTiming(node.getTiming());
    setReadBack(node.getReadBack());
    setWaiting(node.getWaiting());
    setWaitingLimit(node.getWaitingLimit());
    setBricksCallback(node.getBricksCallback().get());
    setAppearance(node.getAppearance());
    setLightProbe(node.getLightProbe());
    setStoredBricks(node.getStoredBricks());
    setBuildingPlan(node.getBuildingPlan());
    setNumNewParts(node.getNumNewParts());
    setUpdateMode(node.getUpdateMode());
}

LegoNode::~LegoNode() = default;

bool LegoNode::setSettings(const LegoSettings& settings)
{
    // Stored bricks do not need the palette, whose file may not be there any more.
    return changeSettings(settings, !getStoredBricks());
}

bool LegoNode::changeSettings(const LegoSettings& settings, bool requiresPalette)
{
    std::string error = settings.check();
    SettingsPalette palette;
    if (error.empty()) palette = SettingsPalette::read(settings);
    if (requiresPalette && error.empty()) error = palette.error;
    if (!error.empty())
    {
        OSG_WARN << "osgLego: " << error << std::endl;
        return false;
    }
    _pipeline->setSettings(settings, palette);
    requireUpdate();
    return true;
}

LegoSettings LegoNode::getSettings() const
{
    return _pipeline->getSettings();
}

bool LegoNode::setAppearance(const BrickAppearance& appearance)
{
    if (const std::string error = appearance.check(); !error.empty())
    {
        OSG_WARN << "osgLego: " << error << std::endl;
        return false;
    }
    _pipeline->getDisplay().setAppearance(appearance);
    setRequiresUpdate(true);
    return true;
}

BrickAppearance LegoNode::getAppearance() const
{
    return _pipeline->getDisplay().getAppearance();
}

void LegoNode::setLightProbe(const LightProbe* probe)
{
    // A copy, since it is read while frames are culled.
    const osg::ref_ptr<LightProbe> copy = probe ? new LightProbe(*probe) : new LightProbe;
    _pipeline->getDisplay().setLightProbe(*copy);
    setRequiresUpdate(true);
}

osg::ref_ptr<const LightProbe> LegoNode::getLightProbe() const
{
    return _pipeline->getDisplay().getLightProbe();
}

void LegoNode::dirty()
{
    _pipeline->dirty();
    requireUpdate();
}

/** Update the node, and compute its bound, before the next frame. */
void LegoNode::requireUpdate()
{
    dirtyBound();
    setRequiresUpdate(true);
}

bool LegoNode::hasTriangles() const
{
    refreshBetweenFrames();
    return _pipeline->getRevision() != 0 || !_pipeline->getObstacle().empty();
}

std::string LegoNode::getObstacle() const
{
    refreshBetweenFrames();
    return _pipeline->getObstacle();
}

void LegoNode::setTiming(bool timing)
{
    _pipeline->setTiming(timing);
}

bool LegoNode::getTiming() const
{
    return _pipeline->getTiming();
}

void LegoNode::setWaiting(bool waiting)
{
    _pipeline->setWaiting(waiting);
}

bool LegoNode::getWaiting() const
{
    return _pipeline->getWaiting();
}

bool LegoNode::setWaitingLimit(double seconds)
{
    if (!(seconds >= 0.0))
    {
        OSG_WARN << "osgLego: bad limit " << seconds << " for waiting; expected seconds from 0 on" << std::endl;
        return false;
    }
    _pipeline->setWaitingLimit(seconds);
    return true;
}

double LegoNode::getWaitingLimit() const
{
    return _pipeline->getWaitingLimit();
}

void LegoNode::setUpdateMode(UpdateMode mode)
{
    _updateMode = mode;
    setRequiresUpdate(true);
}

void LegoNode::setBricksCallback(BricksCallback* callback)
{
    _bricksCallback = callback;
    if (callback)
        _pipeline->setAnnouncement([kept = _bricksCallback] { kept->ready(); });
    else
        _pipeline->setAnnouncement(nullptr);
}

void LegoNode::setReadBack(bool readBack)
{
    _pipeline->setReadBack(readBack);
}

bool LegoNode::getReadBack() const
{
    return _pipeline->getReadBack();
}

bool LegoNode::setHighlightedParts(std::span<const std::size_t> parts, const std::array<std::uint8_t, 3>& color)
{
    if (!parts.empty()) refreshBetweenFrames();
    if (const std::string error = _pipeline->setHighlightedParts(parts, color); !error.empty())
    {
        OSG_WARN << "osgLego: " << error << std::endl;
        return false;
    }
    setRequiresUpdate(true);
    return true;
}

osg::ref_ptr<const BrickModel> LegoNode::getBricks() const
{
    refreshBetweenFrames();
    return _pipeline->getModel();
}

osg::Matrixd LegoNode::getBricksToNode() const
{
    refreshBetweenFrames();
    return _pipeline->getToNode();
}

osg::ref_ptr<const BrickModel> LegoNode::getShownBricks() const
{
    return _pipeline->getShownModel();
}

LegoProgress LegoNode::getProgress() const
{
    return _pipeline->getProgress();
}

void LegoNode::cancel()
{
    _pipeline->cancel();
}

osg::ref_ptr<const BrickModel> LegoNode::getBricks(unsigned int contextID) const
{
    return getReadBack() ? _pipeline->getStore().getContext(contextID)->getModel() : nullptr;
}

void LegoNode::setStoredBricks(const BrickModel* bricks)
{
    _pipeline->setStoredBricks(bricks);
    requireUpdate();
}

osg::ref_ptr<const BrickModel> LegoNode::getStoredBricks() const
{
    return _pipeline->getStoredBricks();
}

bool LegoNode::setBuildProgress(double progress)
{
    LegoSettings settings;
    settings.view.progress = progress;
    if (const std::string error = settings.check(); !error.empty())
    {
        OSG_WARN << "osgLego: " << error << std::endl;
        return false;
    }
    _pipeline->setProgress(progress);
    setRequiresUpdate(true);
    return true;
}

double LegoNode::getBuildProgress() const
{
    return getSettings().view.progress;
}

void LegoNode::setBuildingPlan(const BuildingPlan* plan)
{
    _pipeline->getBuilding().setPlan(plan);
    setRequiresUpdate(true);
}

osg::ref_ptr<const BuildingPlan> LegoNode::getBuildingPlan() const
{
    return _pipeline->getBuilding().getPlan();
}

void LegoNode::setNumNewParts(std::size_t count)
{
    _pipeline->setNumNewParts(count);
    setRequiresUpdate(true);
}

std::size_t LegoNode::getNumNewParts() const
{
    return _pipeline->getNumNewParts();
}

LegoStatistics LegoNode::getStatistics(unsigned int contextID) const
{
    return _pipeline->getStore().getContext(contextID)->getStatistics();
}

bool LegoNode::isLegolized(unsigned int contextID) const
{
    const std::uint64_t revision = _pipeline->getRevision();
    return !_pipeline->isDirty() && revision != 0 && _pipeline->getStore().getContext(contextID)->shows(revision);
}

bool LegoNode::isSupported(const osg::State& state)
{
    return GlRequirements::getMissing(state).empty();
}

std::string LegoNode::getMissing(const osg::State& state)
{
    return GlRequirements::getMissing(state);
}

std::string LegoNode::getFailure(unsigned int contextID) const
{
    const std::string obstacle = _pipeline->getObstacle();
    return obstacle.empty() ? _pipeline->getStore().getContext(contextID)->getFailure() : obstacle;
}

void LegoNode::traverse(osg::NodeVisitor& visitor)
{
    switch (visitor.getVisitorType())
    {
    case osg::NodeVisitor::UPDATE_VISITOR:
        osg::Group::traverse(visitor);
        update(visitor);
        return;
    case osg::NodeVisitor::EVENT_VISITOR:
        osg::Group::traverse(visitor);
        return;
    case osg::NodeVisitor::CULL_VISITOR:
        cull(visitor);
        return;
    default:
        visitBricks(visitor);
    }
}

/** Check the source for changes unless it is frozen, and record its bound. */
void LegoNode::refresh() const
{
    if (mustRefresh()) _pipeline->refresh(*this);
    _sourceBound = osg::Group::computeBound();
}

bool LegoNode::mustRefresh() const
{
    return _updateMode != UpdateMode::FROZEN || _pipeline->isDirty();
}

/** The same between frames: the next update computes the bound of changed bricks. */
void LegoNode::refreshBetweenFrames() const
{
    refresh();
    // The node itself does not change: the source did, before this call.
    if (_pipeline->isBusy()) const_cast<LegoNode*>(this)->setRequiresUpdate(true);
}

/** Require update traversals, apart from those of children. Several threads may cull nodes at the same time. */
void LegoNode::setRequiresUpdate(bool requiresUpdate)
{
    static std::mutex mutex; // nodes are counted in the same parents
    const std::lock_guard lock(mutex);
    if (std::exchange(_requiresUpdate, requiresUpdate) == requiresUpdate) return;
    const unsigned int count = getNumChildrenRequiringUpdateTraversal();
    setNumChildrenRequiringUpdateTraversal(requiresUpdate ? count + 1 : count - 1);
}

void LegoNode::update(osg::NodeVisitor& visitor)
{
    if (_updateMode == UpdateMode::EVERY_FRAME) _pipeline->dirty();
    if (mustRefresh()) _pipeline->refreshInTime(*this);
    _sourceBound = osg::Group::computeBound();
    if (_pipeline->update(visitor)) dirtyBound();
    setRequiresUpdate(_updateMode == UpdateMode::EVERY_FRAME || _pipeline->isBusy());
}

void LegoNode::cull(osg::NodeVisitor& visitor)
{
    if (_updateMode == UpdateMode::ON_CHANGE)
        _pipeline->refreshInFrame(*this, visitor);
    else
        _pipeline->refreshIfDirty(*this);
    osgUtil::CullVisitor* cullVisitor = visitor.asCullVisitor();
    if (!cullVisitor || !cullBricks(*cullVisitor)) visitSource(visitor);
    if (_pipeline->isBusy()) setRequiresUpdate(true);
}

/** @return false if the source is to be drawn instead. */
bool LegoNode::cullBricks(osgUtil::CullVisitor& visitor)
{
    const osg::Matrixd toNode = _pipeline->getToNode();
    if (toNode.isIdentity()) return _pipeline->cull(visitor);
    visitor.pushModelViewMatrix(new osg::RefMatrix(toNode * *visitor.getModelViewMatrix()),
                                osg::Transform::RELATIVE_RF);
    // The directions of the light follow from the node path.
    const osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(toNode);
    visitor.pushOntoNodePath(place);
    const bool isCulled = _pipeline->cull(visitor);
    visitor.popFromNodePath();
    visitor.popModelViewMatrix();
    return isCulled;
}

/** Let a visitor visit a node that has the coordinates of the bricks. */
void LegoNode::visitAtBricks(osg::Node& node, osg::NodeVisitor& visitor)
{
    const osg::Matrixd toNode = _pipeline->getToNode();
    if (toNode.isIdentity())
    {
        node.accept(visitor);
        return;
    }
    // Kept, because node paths of intersections refer to it.
    if (!_lattice) _lattice = new osg::MatrixTransform;
    if (_lattice->getMatrix() != toNode) _lattice->setMatrix(toNode);
    if (!_lattice->containsNode(&node))
    {
        _lattice->removeChildren(0, _lattice->getNumChildren());
        _lattice->addChild(&node);
    }
    _lattice->accept(visitor);
}

/** Visit the parts that contexts draw that can't draw bricks: the source or, if there are only stored bricks, these as
 * geometry. */
void LegoNode::visitSource(osg::NodeVisitor& visitor)
{
    if (getNumChildren() == 0 && getStoredBricks())
        _pipeline->getGeometryNode()->accept(visitor);
    else
        osg::Group::traverse(visitor);
}

void LegoNode::visitBricks(osg::NodeVisitor& visitor)
{
    if (dynamic_cast<SourceVisitor*>(&visitor))
    {
        // osgLego's own visitors, which examine the source of this node, or this node as a part of another's source.
        osg::ref_ptr<osg::Node> geometry;
        if (visitor.getNodePath().size() > 1)
        {
            _pipeline->refreshIfDirty(*this);
            geometry = _pipeline->getGeometryNode();
        }
        if (geometry)
            visitAtBricks(*geometry, visitor);
        else
            osg::Group::traverse(visitor);
    }
    else if (auto* compiler = dynamic_cast<osgUtil::GLObjectsVisitor*>(&visitor))
    {
        // Compile only what will be drawn.
        const osg::State* state = compiler->getRenderInfo().getState();
        if (!state || _pipeline->isFit(*state))
            _pipeline->getDisplay().getBrickNode()->accept(visitor);
        else
            visitSource(visitor);
    }
    else
    {
        const bool visitsAll = visitor.getTraversalMode() == osg::NodeVisitor::TRAVERSE_ALL_CHILDREN;
        if (visitsAll) osg::Group::traverse(visitor);
        _pipeline->refreshIfDirty(*this);
        if (const std::optional<Meanwhile> meanwhile = _pipeline->getMeanwhile())
        {
            if (meanwhile == Meanwhile::SOURCE && !visitsAll) osg::Group::traverse(visitor);
            return;
        }
        _pipeline->prepareForPicking();
        visitAtBricks(*_pipeline->getDisplay().getBrickNode(), visitor);
    }
}

osg::BoundingSphere LegoNode::computeBound() const
{
    // A child whose bound has not been computed does not report changes of it.
    const osg::BoundingSphere sourceBound = osg::Group::computeBound();
    // If the bound of the source has not changed since the last check, no check is needed before the next update.
    if (_pipeline->isDirty() || sourceBound != _sourceBound) refresh();
    const osg::BoundingBoxd bounds = _pipeline->getBounds();
    return bounds.valid() ? osg::BoundingSphere(osg::BoundingBox(bounds)) : sourceBound;
}

void LegoNode::setThreadSafeRefUnref(bool threadSafe)
{
    osg::Group::setThreadSafeRefUnref(threadSafe);
    _pipeline->getDisplay().getBrickNode()->setThreadSafeRefUnref(threadSafe);
}

void LegoNode::resizeGLObjectBuffers(unsigned int maxSize)
{
    osg::Group::resizeGLObjectBuffers(maxSize);
    _pipeline->resizeGLObjectBuffers(maxSize);
}

void LegoNode::releaseGLObjects(osg::State* state) const
{
    osg::Group::releaseGLObjects(state);
    _pipeline->releaseGLObjects(state);
}

} // namespace osgLego
