#include "LegoNodeContender.h"

#include "BenchEnvironment.h"

#include <stdexcept>
#include <utility>

#include <osg/Camera>

namespace osgLego
{

namespace
{

constexpr int VIEW_SIZE = 16; // pixels; nothing is visible

} // namespace

LegoNodeContender::LegoNodeContender(std::string name, std::string settings) :
    _name(std::move(name)), _settings(std::move(settings))
{
}

std::string LegoNodeContender::prepare(const BenchMesh& mesh, osg::GraphicsContext& context)
{
    LegoSettings settings = mesh.settings;
    std::string error;
    if (!LegoSettings::parse(_settings, settings, error)) return error;
    if (error = settings.check(); !error.empty()) return error;
    _context = &context;
    const osg::State& state = *context.getState();
    if (state.get<osg::GLExtensions>()->isARBTimerQuerySupported && !isSoftwareRenderer())
        _timeStamps = {GlQuery(state), GlQuery(state)};
    _lego = new LegoNode(settings);
    _lego->setTiming(true);
    _lego->setWaiting(true);
    _lego->setCullingActive(false);
    _lego->addChild(mesh.node);
    createView();
    return drawFrame();
}

/** A view of the context that is drawn only if this contender runs. Cameras of one viewer would all be drawn together.
 */
void LegoNodeContender::createView()
{
    _frameStamp = new osg::FrameStamp;
    _view = new osgUtil::SceneView;
    _view->setDefaults();
    _view->setState(_context->getState());
    _view->setFrameStamp(_frameStamp);
    _view->setViewport(0, 0, VIEW_SIZE, VIEW_SIZE);
    _view->getCamera()->setDrawBuffer(GL_BACK);
    _view->getCamera()->setReadBuffer(GL_BACK);
    _view->setProjectionMatrixAsPerspective(30.0, 1.0, 0.1, 100.0);
    _view->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    // All bricks are behind the eye, so none is drawn. They must not be culled, since drawing uploads those of the CPU.
    _view->setCullingMode(osg::CullSettings::NO_CULLING);
    const osg::BoundingSphere bound = _lego->getBound();
    const osg::Vec3d eye = bound.center() + osg::Vec3d(0.0, 0.0, 10.0 * bound.radius());
    _view->setViewMatrixAsLookAt(eye, eye + osg::Vec3d(0.0, 0.0, bound.radius()), osg::Vec3d(0.0, 1.0, 0.0));
    _view->setSceneData(_lego);
}

/** Record the start or end of a frame with the GPU's clock. */
void LegoNodeContender::stampTime(std::size_t end) const
{
    if (const GLuint query = _timeStamps[end].get(); query != 0)
        _context->getState()->get<osg::GLExtensions>()->glQueryCounter(query, GL_TIMESTAMP);
}

/** @return the reason why there are no bricks; empty if there are bricks. */
std::string LegoNodeContender::drawFrame()
{
    _context->makeCurrent();
    _frameStamp->setFrameNumber(_frameStamp->getFrameNumber() + 1);
    _view->update();
    _view->cull();
    stampTime(0);
    _view->draw();
    stampTime(1);
    _view->flushAllDeletedGLObjects();
    const unsigned int contextID = _context->getState()->getContextID();
    if (_lego->isLegolized(contextID)) return {};
    const std::string failure = _lego->getFailure(contextID);
    return failure.empty() ? "the passes did not run" : failure;
}

double LegoNodeContender::run()
{
    _lego->dirty();
    if (const std::string failure = drawFrame(); !failure.empty()) throw std::runtime_error(_name + ": " + failure);
    const LegoStatistics statistics = _lego->getStatistics(_context->getState()->getContextID());
    return statistics.subdivision + statistics.voxelization + statistics.extraction;
}

osg::ref_ptr<const BrickModel> LegoNodeContender::getBricks()
{
    // Off during runs, since applications don't spend time on reading back.
    _lego->setReadBack(true);
    const std::string failure = drawFrame();
    osg::ref_ptr<const BrickModel> bricks = _lego->getBricks(_context->getState()->getContextID());
    _lego->setReadBack(false);
    if (!bricks) throw std::runtime_error(_name + ": " + (failure.empty() ? "no bricks came back" : failure));
    return bricks;
}

void LegoNodeContender::release()
{
    if (_lego)
    {
        _context->makeCurrent();
        _lego->releaseGLObjects(_context->getState());
        _view->releaseAllGLObjects();
        _view->flushAllDeletedGLObjects();
        _timeStamps = {};
    }
    _view = nullptr;
    _lego = nullptr;
    _context = nullptr;
}

Contender::Stages LegoNodeContender::getStages() const
{
    const LegoStatistics statistics = _lego->getStatistics(_context->getState()->getContextID());
    Stages stages{{"subdivision", statistics.subdivision},
                  {"voxelization", statistics.voxelization},
                  {"extraction", statistics.extraction}};
    if (_timeStamps[0].get() == 0) return stages;
    std::array<GLuint64, 2> nanoseconds{};
    for (std::size_t end = 0; end < 2; ++end)
        _context->getState()->get<osg::GLExtensions>()->glGetQueryObjectui64v(_timeStamps[end].get(), GL_QUERY_RESULT,
                                                                              &nanoseconds[end]);
    stages.emplace_back("gpu", 1e-6 * static_cast<double>(nanoseconds[1] - nanoseconds[0]));
    return stages;
}

} // namespace osgLego
