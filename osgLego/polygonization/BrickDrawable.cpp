#include <osgLego/polygonization/BrickDrawable.h>

#include <osgLego/BrickGeometry.h>
#include <osgLego/gl/GlRequirements.h>
#include <osgLego/polygonization/BrickUniforms.h>
#include <osgLego/polygonization/DistantOcclusionView.h>

#include <optional>

#include <osg/CullFace>
#include <osg/Depth>
#include <osg/FrontFace>
#include <osg/PolygonMode>
#include <osg/RenderInfo>
#include <osg/Viewport>

namespace osgLego
{

namespace
{

template <typename Attribute>
const Attribute* findAttribute(const osg::State& state, osg::StateAttribute::Type type)
{
    return dynamic_cast<const Attribute*>(state.getLastAppliedAttribute(type));
}

/** Whether a state shows only the nearest surface, without clipping and blending, so that only the outer sides of
 * closed surfaces are visible. */
bool showsNearestOnly(const osg::State& state, bool isMirrored)
{
    for (const auto mode :
         {GL_BLEND, GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE2, GL_CLIP_PLANE3,
          GL_CLIP_PLANE4, GL_CLIP_PLANE5, GL_CLIP_PLANE0 + 6, GL_CLIP_PLANE0 + 7})
        if (state.getLastAppliedMode(static_cast<osg::StateAttribute::GLMode>(mode))) return false;
    if (!state.getLastAppliedMode(GL_DEPTH_TEST)) return false;
    const auto* depth = findAttribute<osg::Depth>(state, osg::StateAttribute::DEPTH);
    if (depth && (!depth->getWriteMask() ||
                  (depth->getFunction() != osg::Depth::LESS && depth->getFunction() != osg::Depth::LEQUAL)))
        return false;
    const auto* polygonMode = findAttribute<osg::PolygonMode>(state, osg::StateAttribute::POLYGONMODE);
    if (polygonMode && polygonMode->getMode(osg::PolygonMode::FRONT) != osg::PolygonMode::FILL) return false;
    if (polygonMode && polygonMode->getMode(osg::PolygonMode::BACK) != osg::PolygonMode::FILL) return false;
    if (!state.getLastAppliedMode(GL_CULL_FACE)) return true;
    const auto* cullFace = findAttribute<osg::CullFace>(state, osg::StateAttribute::CULLFACE);
    return !isMirrored && (!cullFace || cullFace->getMode() == osg::CullFace::BACK);
}

/** Whether clockwise faces are front faces in a state. */
bool isClockwise(const osg::State& state)
{
    const auto* frontFace = findAttribute<osg::FrontFace>(state, osg::StateAttribute::FRONTFACE);
    return frontFace && frontFace->getMode() == osg::FrontFace::CLOCKWISE;
}

} // namespace

BrickDrawable::BrickDrawable(const Options& options, osg::StateSet& geometryState, osg::StateSet& splatState,
                             osg::StateSet& splatStateByOneLight) :
    _store(options.store),
    _drawing(options.drawing), _isPartial(options.isPartial), _outline(options.outline),
    _noOcclusion(options.hasDistantOcclusion ? new DistantOcclusionTexture : nullptr), _geometryState(&geometryState),
    _splats(splatState, splatStateByOneLight, options.isPartial)
{
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setDataVariance(osg::Object::STATIC);
}

osg::BoundingBox BrickDrawable::computeBoundingBox() const
{
    const osg::BoundingBoxd bounds = _store->getBounds();
    if (!bounds.valid()) return {};
    return {osg::Vec3(bounds._min), osg::Vec3(bounds._max)};
}

void BrickDrawable::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    const unsigned int contextID = state.getContextID();
    const osg::ref_ptr<ContextBricks> bricks = _store->getContext(contextID);
    if (const std::string& missing = GlRequirements::getMissing(state); !missing.empty())
    {
        bricks->markUnsupported(contextID, missing);
        return;
    }
    // Before the context is locked: the store locks itself first, and contexts after that.
    const Shown shown{_store->getBricks(), _isPartial ? _store->getBuilding() : nullptr, _store->getState()};
    const std::lock_guard lock(bricks->getMutex());
    state.unbindVertexBufferObject();
    if (!prepare(state, *bricks, shown) || !state.getLastAppliedProgramObject()) return;

    // Bricks have cell coordinates. The transform to eye coordinates is computed in double precision, so that models
    // far from the origin of their coordinates do not jitter.
    const BrickGrid& grid = _isPartial ? bricks->building->getModel().getGrid() : bricks->bricks->getGrid();
    // osg::State accepts matrices only as osg::RefMatrix.
    const osg::ref_ptr<const osg::RefMatrix> modelView =
        static_cast<const osg::RefMatrix*>(&state.getModelViewMatrix());
    Workspace& workspace = _workspaces[contextID];
    if (!workspace.cellsToEye) workspace.cellsToEye = new osg::RefMatrix;
    workspace.cellsToEye->set(grid.getCellsToModel() * *modelView);
    state.applyModelViewMatrix(workspace.cellsToEye.get());
    if (state.getUseModelViewAndProjectionUniforms()) state.applyModelViewAndProjectionUniformsIfRequired();
    const osg::Viewport* viewport = state.getCurrentViewport();
    const double width = viewport ? viewport->width() : 1.0;
    std::optional<DistantOcclusionView> distant;
    if (_noOcclusion)
    {
        // The distant occlusion is that of all bricks.
        DistantOcclusionTexture* texture = _isPartial ? nullptr : bricks->findDistantOcclusion(state);
        distant.emplace(texture ? *texture : *_noOcclusion, *workspace.cellsToEye, state.getProjectionMatrix(), width);
    }
    const BrickLines lines(_outline, _isPartial && shown.state.numNew > 0, *workspace.cellsToEye,
                           state.getProjectionMatrix(), width);
    drawBricks(state, _isPartial ? DrawnBricks(*bricks, shown.state, lines) : DrawnBricks(*bricks, lines), workspace,
               distant ? &*distant : nullptr);
    state.applyModelViewMatrix(modelView.get());
}

/** Upload the newest bricks if they are not there yet. The caller holds the mutex of `bricks`.
 * @return whether there are bricks to draw. */
bool BrickDrawable::prepare(const osg::State& state, ContextBricks& bricks, const Shown& shown) const
{
    // Also if they are drawn partly built, so that the last frame of an animation has nothing to upload.
    if (shown.bricks && shown.bricks->hasPoints()) bricks.upload(state, *shown.bricks);
    bricks.pollBlocks(state);
    if (!_isPartial) return bricks.numBricks > 0;
    return shown.building && bricks.upload(state, *shown.building) && !shown.building->getPoints().points.empty();
}

void BrickDrawable::drawBricks(osg::State& state, const DrawnBricks& bricks, Workspace& workspace,
                               const DistantOcclusionView* distant) const
{
    CellView view(bricks.grid, *workspace.cellsToEye, state.getProjectionMatrix());
    view.isMirrored = view.isMirrored != isClockwise(state);
    const bool showsInsides = view.isCutOpen || !showsNearestOnly(state, view.isMirrored);
    workspace.ranges.find(bricks.blocks, bricks.grid, view, showsInsides, bricks.numPlaced);
    // Polygon offset depends on the slopes of triangles.
    const bool isOffset = state.getLastAppliedMode(GL_POLYGON_OFFSET_FILL);
    if (!showsInsides && !isOffset && _drawing != Drawing::TRIANGLES)
    {
        const bool isDrawn = _splats.draw(state, bricks, workspace.ranges, view, _drawing, distant);
        state.apply(_geometryState);
        if (isDrawn || !state.getLastAppliedProgramObject()) return;
        if (state.getUseModelViewAndProjectionUniforms()) state.applyModelViewAndProjectionUniformsIfRequired();
    }
    // Front to back, so that fewer hidden pixels are shaded.
    if (!showsInsides) workspace.ranges.sortFrontToBack();
    setBrickUniforms(state, bricks, view, showsInsides);
    if (distant) distant->apply(state);
    drawBrickPoints(state, bricks, workspace.ranges.getAll());
}

osg::ref_ptr<const BrickModel> BrickDrawable::getModel() const
{
    if (_isPartial)
        if (const osg::ref_ptr<const BuildingSet> building = _store->getBuilding()) return &building->getModel();
    const osg::ref_ptr<const BrickSet> bricks = _store->getBricks();
    return bricks ? bricks->getModel() : nullptr;
}

osg::ref_ptr<const BrickModel> BrickDrawable::getPlacedModel() const
{
    if (_isPartial)
        if (const osg::ref_ptr<const BuildingSet> building = _store->getBuilding())
            return building->getPlacedModel(building->getNumPlaced(_store->getState().progress));
    return getModel();
}

void BrickDrawable::accept(osg::PrimitiveFunctor& functor) const
{
    if (const osg::ref_ptr<const BrickModel> model = getPlacedModel()) acceptBrickTriangles(*model, functor);
}

void BrickDrawable::resizeGLObjectBuffers(unsigned int maxSize)
{
    osg::Drawable::resizeGLObjectBuffers(maxSize);
    _workspaces.resize(maxSize);
    _splats.resizeGLObjectBuffers(maxSize);
    if (_noOcclusion) _noOcclusion->resizeGLObjectBuffers(maxSize);
}

void BrickDrawable::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    _splats.releaseGLObjects(state);
    if (_noOcclusion) _noOcclusion->releaseGLObjects(state);
    _store->releaseGLObjects(state);
}

} // namespace osgLego
