#include <osgLego/passes/LegolizationPass.h>

#include <osgLego/gl/GlRequirements.h>
#include <osgLego/passes/SurfaceBinding.h>

#include <new>

#include <osg/RenderInfo>
#include <osg/Timer>

namespace osgLego
{

LegolizationPass::LegolizationPass(BrickStore& store, unsigned int step) : _store(&store), _step(step)
{
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setCullingActive(false);
    setDataVariance(osg::Object::STATIC);
}

void LegolizationPass::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    const osg::ref_ptr<ContextBricks> bricks = _store->getContext(state.getContextID());
    if (const std::string& missing = GlRequirements::getMissing(state); !missing.empty())
    {
        bricks->despair(state.getContextID(), missing);
        return;
    }
    const std::lock_guard lock(bricks->getMutex());
    if (!begin(state, *bricks)) return;

    osg::ref_ptr<const LegoSource> source = bricks->work->source;
    const osg::Timer_t start = osg::Timer::instance()->tick();
    std::string failure;
    if (hasProgram() && !state.getLastAppliedProgramObject())
        failure = std::string("the shaders of ") + className() + " do not compile";
    else
    {
        state.disableAllVertexArrays();
        state.unbindVertexBufferObject();
        try
        {
            failure = run(state, *bricks);
        }
        catch (const std::bad_alloc&)
        {
            failure = "there is no memory for so many bricks; allowed: a lower resolution";
        }
    }
    if (!failure.empty())
    {
        bricks->fail(*source, failure);
        return;
    }
    // The last pass has finished the work, and moved its statistics.
    if (source->timing) glFinish();
    LegoStatistics& statistics = bricks->work ? bricks->work->statistics : bricks->statistics;
    getTime(statistics) += osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    if (bricks->work) ++bricks->work->nextStep;
}

bool LegolizationPass::begin(osg::State& state, ContextBricks& bricks) const
{
    return bricks.work && bricks.work->owner == state.getGraphicsContext() && bricks.work->nextStep == _step;
}

bool LegolizationPass::start(osg::State& state, ContextBricks& bricks, const PassPlan& plan) const
{
    const osg::ref_ptr<const LegoSource> source = _store->getSource();
    if (!source || bricks.getFailedRevision() == source->revision || bricks.isOf(*source)) return false;
    // The source may have changed since the frame was culled: then the next frame has passes that fit.
    if (!plan.fits(*source)) return false;
    const bool isOthers = bricks.work && bricks.work->owner != state.getGraphicsContext();
    if (isOthers) return false;

    bricks.work = std::make_unique<Legolization>();
    bricks.work->source = source;
    bricks.work->owner = state.getGraphicsContext();
    bricks.work->statistics.numTriangles = source->triangles->getNumTriangles();
    bricks.work->statistics.flattening = source->flattening;
    return true;
}

void LegolizationPass::bindSurfaceOf(osg::State& state, const GridBatch& batch) const
{
    const osg::ref_ptr<osg::Texture2D> texture = batch.texture ? _store->getTexture(*batch.texture) : nullptr;
    bindSurface(state, batch, texture.get());
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
