#include <osgLego/occlusion/GeometryBufferStage.h>

#include <osgLego/gl/GlMemory.h>
#include <osgLego/gl/PassState.h>

#include <algorithm>
#include <atomic>

#include <osg/RenderInfo>
#include <osg/Timer>

namespace osgLego
{

/** Draws only if the buffer is complete: otherwise OSG would draw into the window. */
class GeometryBufferStage::Draw : public osgUtil::RenderBin::DrawCallback
{
public:
    void drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& renderInfo,
                            osgUtil::RenderLeaf*& previous) override
    {
        if (!isTargetThere(*renderInfo.getState()))
        {
            takeOutOfMemoryError();
            hasFailed = true;
            return;
        }
        const osg::Timer_t start = osg::Timer::instance()->tick();
        bin->drawImplementation(renderInfo, previous);
        if (!isTimed) return;
        glFinish();
        time = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    }

    std::atomic<bool> hasFailed{false};
    std::atomic<bool> isTimed{false};
    std::atomic<double> time{0.0};
};

GeometryBufferStage::GeometryBufferStage() : _draw(new Draw)
{
    setDrawCallback(_draw);
}

GeometryBufferStage::~GeometryBufferStage() = default;

void GeometryBufferStage::setTiming(bool timing)
{
    _draw->isTimed = timing;
}

double GeometryBufferStage::getTime() const
{
    return _draw->isTimed ? _draw->time.load() : 0.0;
}

bool GeometryBufferStage::hasFailed() const
{
    return _draw->hasFailed;
}

void GeometryBufferStage::resetFor(osgUtil::RenderStage& outer)
{
    // Not to be reset: it has the lights that the frame has so far.
    setPositionalStateContainer(nullptr);
    reset();
    setPositionalStateContainer(outer.getPositionalStateContainer());
    setInheritedPositionalStateContainer(outer.getInheritedPositionalStateContainer());
    setInheritedPositionalStateContainerMatrix(outer.getInheritedPositionalStateContainerMatrix());
}

void GeometryBufferStage::reset()
{
    osgUtil::RenderStage::reset();
    _pitch = 0.0;
}

void GeometryBufferStage::cull(osgUtil::CullVisitor& visitor, const std::function<void()>& cullChildren)
{
    const osg::ref_ptr<osgUtil::RenderBin> outer = visitor.getCurrentRenderBin();
    _root = visitor.getRenderStage();
    setCamera(outer->getStage()->getCamera());
    visitor.setRenderStage(this);
    osgUtil::RenderStage& frame = *outer->getStage();
    setClearColor(frame.getClearColor());
    setClearMask(frame.getClearMask());
    cullChildren();
    // An osg::ClearNode among the children is for the frame, too.
    frame.setClearColor(getClearColor());
    frame.setClearMask(getClearMask());
    setClearColor(osg::Vec4());
    setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    visitor.setRenderStage(_root);
    visitor.setCurrentRenderBin(outer);
    _root = nullptr;
    // The callbacks and attachments of the camera are for the outer stage.
    setCamera(nullptr);
}

void GeometryBufferStage::handOnPostRenderStages(osgUtil::RenderStage& outer)
{
    for (const auto& [order, stage] : _postRenderList)
        outer.addPostRenderStage(stage, order);
    _postRenderList.clear();
}

void GeometryBufferStage::noteBricks(double pitch, const osg::Matrixd& modelView)
{
    const double scale = osg::Matrixd::transform3x3(osg::Vec3d(1.0, 0.0, 0.0), modelView).length();
    _pitch = std::max(_pitch, scale * pitch);
}

} // namespace osgLego
