#include <osgLego/polygonization/BrickDrawable.h>

#include <osgLego/BrickGeometry.h>
#include <osgLego/gl/GlRequirements.h>
#include <osgLego/polygonization/BrickUniforms.h>
#include <osgLego/polygonization/DepthPass.h>
#include <osgLego/polygonization/PartialNeighbors.h>

#include <algorithm>
#include <cstddef>

#include <osg/RenderInfo>
#include <osg/Viewport>
#include <osgUtil/RenderBin>
#include <osgUtil/RenderLeaf>
#include <osgUtil/StateGraph>

namespace osgLego
{

namespace
{

double getPictureWidth(const osg::State& state)
{
    const osg::Viewport* viewport = state.getCurrentViewport();
    return viewport ? viewport->width() : 1.0;
}

/** Whether a job was prepared for these bricks. */
bool isOf(const SplatJob& job, const DrawnBricks& bricks)
{
    return job.buffer == bricks.buffer && job.numSplats == bricks.count && job.blocks == bricks.blocks.data();
}

} // namespace

BrickDrawable::BrickDrawable(const Options& options, const BrickStates& states) :
    _store(options.store), _drawing(options.drawing), _isPartial(options.isPartial), _outline(options.outline),
    _hasGridOcclusion(options.hasGridOcclusion), _occluder(options.occluder),
    _noOcclusion(options.hasDistantOcclusion ? new DistantOcclusionTexture : nullptr), _states(&states), _splats(states)
{
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setDataVariance(osg::Object::STATIC);
}

BrickDrawable::~BrickDrawable()
{
    SharedGlObjects::get().removeUser(this);
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
    const SplatDestination destination(state);
    const bool hasColors = !isDepthPass(renderInfo);
    SplatJob* const job = hasColors ? findSplats(renderInfo, destination) : nullptr;
    const Shown shown = getShown();
    if (!state.getLastAppliedProgramObject())
    {
        bricks->failPrograms("the shaders that draw bricks failed to compile");
        // Triangles that are drawn instead may replace others, which are deleted. OSG compares addresses of arrays, so
        // that it may take new ones for those that it has set.
        state.disableAllVertexArrays();
        return;
    }
    const std::lock_guard lock(bricks->getMutex());
    state.unbindVertexBufferObject();
    if (!prepare(state, *bricks, shown)) return;
    // A job is for the blocks that were known when its points were drawn.
    if (!job) bricks->pollBlocks(state);

    // osg::State accepts matrices only as osg::RefMatrix.
    const osg::ref_ptr<const osg::RefMatrix> modelView =
        static_cast<const osg::RefMatrix*>(&state.getModelViewMatrix());
    Workspace& workspace = _workspaces[contextID];
    if (!workspace.cellsToEye) workspace.cellsToEye = new osg::RefMatrix;
    workspace.cellsToEye->set(getCellsToEye(*bricks, *modelView));
    state.applyModelViewMatrix(workspace.cellsToEye.get());
    if (state.getUseModelViewAndProjectionUniforms()) state.applyModelViewAndProjectionUniformsIfRequired();
    const DrawnBricks drawn = getDrawn(state, *bricks, shown, *workspace.cellsToEye);
    if (hasColors)
        drawColors(renderInfo, destination, *bricks, drawn, job, *modelView);
    else
        drawDepths(state, destination, drawn, workspace, CoreClipPlanes(renderInfo));
    state.applyModelViewMatrix(modelView.get());
}

/** Draw bricks in light. The caller holds the mutex of `bricks`.
 * @param job null if splats can't be used.
 * @param modelView the node's, instead of that of the cells, which is applied. */
void BrickDrawable::drawColors(osg::RenderInfo& renderInfo, const SplatDestination& destination, ContextBricks& bricks,
                               const DrawnBricks& drawn, const SplatJob* job, const osg::Matrixd& modelView) const
{
    osg::State& state = *renderInfo.getState();
    Workspace& workspace = _workspaces[state.getContextID()];
    const BrickLight light = findLight(renderInfo, bricks, drawn, modelView);
    if (!job || !drawSplats(state, destination, drawn, *job, light))
        drawTriangles(state, drawn, workspace, light, CoreClipPlanes(renderInfo));
}

/** The caller holds the mutex of `bricks`. */
BrickLight BrickDrawable::findLight(osg::RenderInfo& renderInfo, ContextBricks& bricks, const DrawnBricks& drawn,
                                    const osg::Matrixd& modelView) const
{
    osg::State& state = *renderInfo.getState();
    const osg::Vec3d firstCell = getCellsToEye(bricks, modelView).getTrans();
    BrickLight light{CoreLights(renderInfo), ShadowMaps(renderInfo, firstCell), {}, {}, _occluder};
    const Occlusion occlusion = findOcclusion(state, bricks);
    if (_hasGridOcclusion)
        light.near.emplace(_isPartial ? findPartialNeighbors(state, bricks, drawn, *_states) : occlusion.near,
                           drawn.lines.pixelWidth);
    if (!_noOcclusion) return light;
    const double share = _isPartial ? static_cast<double>(drawn.numPlaced) /
                                          static_cast<double>(std::max<std::size_t>(bricks.building->getNumParts(), 1))
                                    : 1.0;
    const bool isExact = !_isPartial && !bricks.hasOldDistantOcclusion(getNearOcclusion());
    light.distant.emplace(occlusion.distant ? *occlusion.distant : *_noOcclusion, isExact, modelView,
                          state.getProjectionMatrix(), getPictureWidth(state), share);
    return light;
}

NearOcclusion BrickDrawable::getNearOcclusion() const
{
    return _hasGridOcclusion ? NearOcclusion::GRID : NearOcclusion::PICTURE;
}

/** The occlusion of all bricks. The caller holds the mutex of `bricks`. */
BrickDrawable::Occlusion BrickDrawable::findOcclusion(const osg::State& state, ContextBricks& bricks) const
{
    Occlusion found;
    // Also while they are partly built, so that the last frame of an animation has nothing to upload.
    if (_hasGridOcclusion) found.near = bricks.findGridOcclusion(state);
    // Of a partly built model, surfaces that stay visible get the share of the parts in place; others are inside the
    // complete model, where no distant bricks occlude.
    if (_noOcclusion && (_hasGridOcclusion || !_isPartial))
        found.distant = bricks.findDistantOcclusion(state, getNearOcclusion());
    return found;
}

BrickDrawable::Shown BrickDrawable::getShown() const
{
    return {_store->getBricks(), _isPartial ? _store->getBuilding() : nullptr, _store->getState(),
            _store->getHighlight()};
}

/** Bricks have cell coordinates. Their transform to eye coordinates is computed in double precision, so that models far
 * from the origin of their coordinates do not jitter. */
osg::Matrixd BrickDrawable::getCellsToEye(const ContextBricks& bricks, const osg::Matrixd& modelView) const
{
    const BrickGrid& grid = _isPartial ? bricks.building->getModel().getGrid() : bricks.bricks->getGrid();
    return grid.getCellsToModel() * modelView;
}

DrawnBricks BrickDrawable::getDrawn(const osg::State& state, const ContextBricks& bricks, const Shown& shown,
                                    const osg::Matrixd& cellsToEye) const
{
    const BrickLines lines(_outline, _isPartial && shown.state.numNew > 0, cellsToEye, state.getProjectionMatrix(),
                           getPictureWidth(state));
    return _isPartial ? DrawnBricks(bricks, shown.state, lines) : DrawnBricks(bricks, lines);
}

/** Upload the newest bricks if they are not there yet. The caller holds the mutex of `bricks`.
 * @return whether there are bricks to draw. */
bool BrickDrawable::prepare(const osg::State& state, ContextBricks& bricks, const Shown& shown) const
{
    // Also if they are drawn partly built, so that the last frame of an animation has nothing to upload.
    if (shown.bricks && shown.bricks->hasPoints()) bricks.upload(state, *shown.bricks);
    const bool hasBuilding = _isPartial && shown.building && bricks.upload(state, *shown.building);
    bricks.highlight(state, shown.highlight);
    if (!_isPartial) return bricks.numBricks > 0;
    return hasBuilding && !shown.building->getPoints().points.empty();
}

/** Find the job for drawing the bricks as splats, and draw its points unless they have been drawn: together with those
 * of the following nodes, since renderers are slow to change the frame buffer.
 * @return null if splats can't be used. */
SplatJob* BrickDrawable::findSplats(osg::RenderInfo& renderInfo, const SplatDestination& destination) const
{
    osg::State& state = *renderInfo.getState();
    SplatTarget& target = _splats.getTarget(state);
    if (_drawing == Drawing::TRIANGLES || destination.hasSamples() || !state.getLastAppliedProgramObject() ||
        !target.isUsable())
        return nullptr;
    // Splats of partly built models have their numbers in other bits.
    const std::optional<SplatPicture> picture = _isPartial ? std::nullopt : SplatPicture::find(renderInfo, destination);
    const osg::ref_ptr<const osg::RefMatrix> modelView =
        static_cast<const osg::RefMatrix*>(&state.getModelViewMatrix());
    SplatJob* found = target.find(picture, *this, *modelView);
    if (!found)
    {
        state.unbindVertexBufferObject();
        const std::size_t first = target.begin(picture, *this, *modelView);
        addSplats(state, destination, *modelView);
        if (picture) addFollowing(renderInfo, destination);
        const bool isReady = drawPoints(state, destination, first);
        destination.restore();
        state.applyModelViewMatrix(modelView.get());
        state.apply(&_states->getTriangles());
        if (!isReady) target.fail();
        found = isReady ? &target.getJob(first) : nullptr;
    }
    if (found) found->isShaded = true;
    return found && found->isPossible ? found : nullptr;
}

/** Add a job for the splats of this node. */
void BrickDrawable::addSplats(const osg::State& state, const SplatDestination& destination,
                              const osg::Matrixd& modelView) const
{
    SplatJob& job = _splats.getTarget(state).addJob();
    job.node = this;
    job.modelView = modelView;
    job.isPossible = false;
    job.isShaded = false;
    const osg::ref_ptr<ContextBricks> bricks = _store->getContext(state.getContextID());
    const Shown shown = getShown();
    const std::lock_guard lock(bricks->getMutex());
    if (!prepare(state, *bricks, shown)) return;
    bricks->pollBlocks(state);
    // Before the blocks are culled, since they may become known with the occlusion, too.
    findOcclusion(state, *bricks);
    if (!job.cellsToEye) job.cellsToEye = new osg::RefMatrix;
    job.cellsToEye->set(getCellsToEye(*bricks, modelView));
    const DrawnBricks drawn = getDrawn(state, *bricks, shown, *job.cellsToEye);
    job.view.emplace(createView(state, drawn.grid, *job.cellsToEye));
    // Polygon offset depends on the slopes of triangles.
    if (findVisibleFaces(state, *job.view) != Faces::FRONT || state.getLastAppliedMode(GL_POLYGON_OFFSET_FILL)) return;
    job.ranges.find(drawn.blocks, drawn.grid, *job.view, Faces::FRONT, drawn.numPlaced);
    job.isPossible = _splats.prepare(state, destination, drawn, job);
}

/** Add jobs for the nodes that are drawn with the same state after this one. */
void BrickDrawable::addFollowing(osg::RenderInfo& renderInfo, const SplatDestination& destination) const
{
    const osg::State& state = *renderInfo.getState();
    const osg::Matrixd& modelView = state.getModelViewMatrix();
    for (const osgUtil::StateGraph* graph : renderInfo.getRenderBinStack().back()->getStateGraphList())
    {
        if (graph->getStateSet() != &_states->getTriangles()) continue;
        const auto own =
            std::find_if(graph->_leaves.begin(), graph->_leaves.end(),
                         [&](const auto& leaf) { return leaf->_drawable == this && *leaf->_modelview == modelView; });
        if (own == graph->_leaves.end()) continue;
        for (auto leaf = own + 1; leaf != graph->_leaves.end(); ++leaf)
        {
            const auto* node = dynamic_cast<const BrickDrawable*>((*leaf)->_drawable.get());
            if (node && !node->_isPartial && node->_drawing != Drawing::TRIANGLES &&
                *(*leaf)->_projection == state.getProjectionMatrix())
                node->addSplats(state, destination, *(*leaf)->_modelview);
        }
        return;
    }
}

/** Draw the points of jobs into the target, from a first one on.
 * @return false if a program or the target can't be created. */
bool BrickDrawable::drawPoints(osg::State& state, const SplatDestination& destination, std::size_t first) const
{
    SplatTarget& target = _splats.getTarget(state);
    bool isBound = false;
    for (const bool hasStuds : {false, true})
    {
        bool isApplied = false;
        for (std::size_t index = first; index < target.getNumJobs(); ++index)
        {
            const SplatJob& job = target.getJob(index);
            if (!job.isPossible) continue;
            const osg::ref_ptr<ContextBricks> bricks = job.node->_store->getContext(state.getContextID());
            const Shown shown = job.node->getShown();
            const std::lock_guard lock(bricks->getMutex());
            if (!job.node->prepare(state, *bricks, shown)) continue;
            const DrawnBricks drawn = job.node->getDrawn(state, *bricks, shown, *job.cellsToEye);
            if (!isOf(job, drawn) || !BrickSplats::hasPoints(drawn, job, hasStuds)) continue;
            state.applyModelViewMatrix(job.cellsToEye.get());
            if (!isApplied && !applyBrickState(state, _states->getPoints(hasStuds))) return false;
            if (isApplied && state.getUseModelViewAndProjectionUniforms())
                state.applyModelViewAndProjectionUniformsIfRequired();
            isApplied = true;
            if (!isBound && !target.bind(state, destination.getSize())) return false;
            isBound = true;
            BrickSplats::drawPoints(state, drawn, job, hasStuds, destination.getSize());
        }
    }
    return true;
}

/** Shade splats whose points have been drawn.
 * @return false, with nothing drawn, if that is impossible. */
bool BrickDrawable::drawSplats(osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                               const SplatJob& job, const BrickLight& light) const
{
    if (!isOf(job, bricks)) return false;
    const bool isDrawn = _splats.shade(state, destination, bricks, job, light);
    state.apply(&_states->getTriangles());
    if (state.getLastAppliedProgramObject() && state.getUseModelViewAndProjectionUniforms())
        state.applyModelViewAndProjectionUniformsIfRequired();
    return isDrawn || !state.getLastAppliedProgramObject();
}

void BrickDrawable::drawTriangles(osg::State& state, const DrawnBricks& bricks, Workspace& workspace,
                                  const BrickLight& light, const CoreClipPlanes& clipPlanes) const
{
    const CellView view = createView(state, bricks.grid, *workspace.cellsToEye);
    const Faces faces = findVisibleFaces(state, view);
    workspace.ranges.find(bricks.blocks, bricks.grid, view, faces, bricks.numPlaced);
    // Front to back, so that fewer hidden pixels are shaded.
    if (faces == Faces::FRONT) workspace.ranges.sortFrontToBack();
    const bool hasShadows = !light.shadows.isEmpty();
    const bool isOther = hasShadows || !clipPlanes.isEmpty(); // than the state that OSG has applied
    if (isOther && !applyBrickState(state, clipPlanes.isEmpty() ? *_states->getShading(true).triangles
                                                                : _states->getClippedTriangles(hasShadows)))
        return;
    setBrickUniforms(state, bricks, view, faces);
    light.apply(state);
    clipPlanes.apply(state);
    drawBrickPoints(state, bricks, workspace.ranges.getAll());
    if (isOther) state.apply(&_states->getTriangles());
}

/** Draw into a depth buffer without colours, such as a shadow map. */
void BrickDrawable::drawDepths(osg::State& state, const SplatDestination& destination, const DrawnBricks& bricks,
                               Workspace& workspace, const CoreClipPlanes& clipPlanes) const
{
    const CellView view = createView(state, bricks.grid, *workspace.cellsToEye);
    const Faces faces = findVisibleFaces(state, view);
    workspace.ranges.find(bricks.blocks, bricks.grid, view, faces, bricks.numPlaced);
    const bool hasSplats = _drawing != Drawing::TRIANGLES && _splats.getTarget(state).isUsable() &&
                           _splats.drawDepths(state, destination, bricks, {view, faces, workspace.ranges});
    if (!hasSplats && applyBrickState(state, _states->getDepths(!clipPlanes.isEmpty())))
    {
        setBrickUniforms(state, bricks, view, faces);
        clipPlanes.apply(state);
        drawBrickPoints(state, bricks, workspace.ranges.getAll());
    }
    state.apply(&_states->getTriangles());
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
    _states->resizeGLObjectBuffers(maxSize);
    if (_noOcclusion) _noOcclusion->resizeGLObjectBuffers(maxSize);
}

void BrickDrawable::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    _splats.releaseGLObjects(state);
    if (_noOcclusion) _noOcclusion->releaseGLObjects(state);
    _store->releaseGLObjects(state);
    SharedGlObjects::get().release(state, this);
}

} // namespace osgLego
