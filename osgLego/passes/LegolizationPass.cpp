#include <osgLego/passes/LegolizationPass.h>

#include <osgLego/gl/CoreVertexArray.h>
#include <osgLego/gl/GlRequirements.h>
#include <osgLego/passes/SurfaceBinding.h>

#include <new>
#include <utility>

#include <osg/RenderInfo>
#include <osg/Timer>

namespace osgLego
{

LegolizationPass::LegolizationPass(PassWorkspace& workspace, unsigned int step) : _workspace(&workspace), _step(step)
{
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setCullingActive(false);
    setDataVariance(osg::Object::STATIC);
}

void LegolizationPass::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    const unsigned int contextID = state.getContextID();
    ContextBricks& shown = *_workspace->getStore().getContext(contextID);
    if (const std::string& missing = GlRequirements::getMissing(state); !missing.empty())
    {
        shown.markUnsupported(contextID, missing);
        return;
    }
    const osg::ref_ptr<PassContext> context = _workspace->getContext(contextID);
    const std::lock_guard lock(context->mutex);
    if (!begin(state, *context)) return;

    Legolization& work = *context->work;
    const osg::Timer_t start = osg::Timer::instance()->tick();
    if (const std::string failure = runWithProgram(state, work); !failure.empty())
    {
        const std::uint64_t revision = work.source->revision;
        context->work.reset();
        if (state.getLastAppliedProgramObject())
            shown.fail(revision, failure);
        else
            shown.failPrograms(failure);
        return;
    }
    if (work.source->timing) glFinish();
    getTime(work.statistics) += osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    ++work.nextStep;
    if (!work.isComplete) return;
    deliver(state, work);
    // Otherwise, the buffers would still take memory while the frame is drawn.
    for (WorkingBatch& batch : work.batches)
        batch.deleteNow(state);
    context->work.reset();
}

std::string LegolizationPass::runWithProgram(osg::State& state, Legolization& work) const
{
    if (!state.getLastAppliedProgramObject())
        return std::string("the shaders of ") + className() + " failed to compile";
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    const CoreVertexArray vertexArray(state);
    try
    {
        return run(state, work);
    }
    catch (const std::bad_alloc&)
    {
        return "there is not enough memory for the bricks; expected a lower resolution";
    }
}

/** Show the bricks in this context, and deliver their set to the store. */
void LegolizationPass::deliver(const osg::State& state, Legolization& work) const
{
    GpuBricks made;
    made.bricks = work.bricks;
    made.buffer = std::move(work.buffer);
    made.neighbors = std::move(work.neighbors);
    made.numBricks = static_cast<GLsizei>(work.numBricks);
    if (work.source->readBack)
        made.model = BrickModel::create(work.source->triangles->getGrid(), std::move(work.readBack));
    made.statistics = work.statistics;
    BrickStore& store = _workspace->getStore();
    store.getContext(state.getContextID())->show(state, std::move(made));
    store.deliver(*work.bricks);
}

bool LegolizationPass::begin(osg::State& state, PassContext& context) const
{
    return context.work && context.work->owner == state.getGraphicsContext() && context.work->nextStep == _step;
}

bool LegolizationPass::start(osg::State& state, PassContext& context, const PassPlan& plan) const
{
    const auto [source, bricks] = _workspace->getWanted();
    const osg::ref_ptr<const ContextBricks> shown = _workspace->getStore().getContext(state.getContextID());
    if (!source || bricks->getRevision() != source->revision) return false;
    if (shown->getFailedRevision() == source->revision || shown->isOf(source->revision)) return false;
    // If the source has changed since the frame was culled, the next frame will have passes that fit.
    if (!plan.fits(*source)) return false;
    const bool isOthers = context.work && context.work->owner != state.getGraphicsContext();
    if (isOthers) return false;

    context.work = std::make_unique<Legolization>();
    context.work->source = source;
    context.work->bricks = bricks;
    context.work->owner = state.getGraphicsContext();
    context.work->statistics.numTriangles = source->triangles->getNumTriangles();
    context.work->statistics.flattening = source->flattening;
    return true;
}

void LegolizationPass::bindSurfaceOf(osg::State& state, const GridBatch& batch) const
{
    const osg::ref_ptr<osg::Texture2D> texture = batch.texture ? _workspace->getTexture(*batch.texture) : nullptr;
    bindSurface(state, batch, texture.get());
}

void LegolizationPass::bindPaletteOf(osg::State& state, const LegoSource& source, unsigned int tableUnit,
                                     unsigned int colorsUnit) const
{
    if (!source.lookup.hasPalette()) return;
    _workspace->getPaletteTextures(source.lookup)->bind(state, tableUnit, colorsUnit);
}

void LegolizationPass::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    _camera->releaseGLObjects(state);
}

void LegolizationPass::resizeGLObjectBuffers(unsigned int maxSize)
{
    osg::Drawable::resizeGLObjectBuffers(maxSize);
    _camera->resizeGLObjectBuffers(maxSize);
}

} // namespace osgLego
