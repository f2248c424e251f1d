#include "BenchScene.h"

#include "BenchEnvironment.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include <osg/GLExtensions>
#include <osg/Math>
#include <osg/Stats>
#include <osg/Timer>

namespace osgLego
{

namespace
{

using PushDebugGroup = void GL_APIENTRY(GLenum source, GLuint id, GLsizei length, const char* message);
using PopDebugGroup = void GL_APIENTRY();

} // namespace

BenchScene::BenchScene(const MeshSource& source, unsigned int resolution) : mesh(source)
{
    settings.grid.resolution = resolution;
    settings.grid.upAxis = source.upAxis;
}

osg::ref_ptr<LegoNode> BenchScene::createLego(BrickOcclusion occlusion) const
{
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    BrickAppearance appearance;
    appearance.occlusion = occlusion;
    lego->setAppearance(appearance);
    lego->addChild(readMesh(mesh));
    lego->setWaiting(true);
    return lego;
}

void BenchScene::placeCamera(osg::Camera& camera, const osg::BoundingSphere& bound, const glm::ivec2& size) const
{
    constexpr double FIELD_OF_VIEW = 30.0;
    const bool isYUp = settings.grid.upAxis == UpAxis::Y;
    const osg::Vec3d up = isYUp ? osg::Vec3d(0, 1, 0) : osg::Vec3d(0, 0, 1);
    const osg::Vec3d front = isYUp ? osg::Vec3d(0, 0, 1) : osg::Vec3d(0, -1, 0);
    const double turn = osg::DegreesToRadians(azimuth);
    const double rise = osg::DegreesToRadians(elevation);
    const osg::Vec3d ahead = front * std::cos(turn) + osg::Vec3d(std::sin(turn), 0, 0);
    const osg::Vec3d toEye = ahead * std::cos(rise) + up * std::sin(rise);
    const double eyeDistance = distance * bound.radius();
    camera.setProjectionMatrixAsPerspective(FIELD_OF_VIEW, static_cast<double>(size.x) / size.y, 0.05 * eyeDistance,
                                            eyeDistance + 4.0 * bound.radius());
    camera.setViewMatrixAsLookAt(osg::Vec3d(bound.center()) + toEye * eyeDistance, bound.center(), up);
}

FrameViewer::FrameViewer(const glm::ivec2& size) : _size(size), _context(createBenchContext(size.x, size.y))
{
    osg::Camera& camera = *_viewer.getCamera();
    camera.setGraphicsContext(_context);
    camera.setViewport(0, 0, size.x, size.y);
    camera.setDrawBuffer(GL_BACK);
    camera.setReadBuffer(GL_BACK);
    camera.setClearColor(osg::Vec4(0.0f, 0.0f, 0.2f, 1.0f));
    camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setReleaseContextAtEndOfFrameHint(false);
}

void FrameViewer::show(osg::Node& node, const BenchScene& scene)
{
    _viewer.setSceneData(&node);
    scene.placeCamera(*_viewer.getCamera(), node.getBound(), _size);
}

double FrameViewer::timeFrame(const char* group)
{
    auto* const push = reinterpret_cast<PushDebugGroup*>(osg::getGLExtensionFuncPtr("glPushDebugGroup"));
    auto* const pop = reinterpret_cast<PopDebugGroup*>(osg::getGLExtensionFuncPtr("glPopDebugGroup"));
    const osg::Timer_t start = osg::Timer::instance()->tick();
    if (push) push(GL_DEBUG_SOURCE_APPLICATION, 0, -1, group);
    _viewer.frame();
    if (pop) pop();
    glFinish(); // outside the group, since this wait is not part of the frame
    return osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
}

FrameViewer::Traversals FrameViewer::timeTraversals()
{
    osg::Stats& frames = *_viewer.getViewerStats();
    osg::Stats& rendering = *_viewer.getCamera()->getStats();
    frames.collectStats("update", true);
    rendering.collectStats("rendering", true);
    timeFrame();
    frames.collectStats("update", false);
    rendering.collectStats("rendering", false);
    const unsigned int frame = _viewer.getFrameStamp()->getFrameNumber();
    const auto read = [frame](const osg::Stats& stats, const char* name)
    {
        double seconds = 0.0;
        if (!stats.getAttribute(frame, name, seconds)) throw std::runtime_error(std::string("OSG measured no ") + name);
        return 1000.0 * seconds;
    };
    return {read(frames, "Update traversal time taken"), read(rendering, "Cull traversal time taken"),
            read(rendering, "Draw traversal time taken")};
}

osg::ref_ptr<osg::Image> FrameViewer::read() const
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->readPixels(0, 0, _size.x, _size.y, GL_RGB, GL_UNSIGNED_BYTE);
    return image;
}

void checkBricks(const LegoNode& lego, const FrameViewer& viewer)
{
    if (lego.isLegolized(viewer.getContextID())) return;
    const std::string failure = lego.getFailure(viewer.getContextID());
    throw std::runtime_error(failure.empty() ? "the frame shows no bricks" : failure);
}

void checkPicture(const osg::Image& picture)
{
    const std::span bytes(picture.data(), picture.getTotalSizeInBytes());
    // All pixels are equal if each byte equals the one that is a pixel before it.
    if (std::equal(bytes.begin() + picture.getPixelSizeInBits() / 8, bytes.end(), bytes.begin()))
        throw std::runtime_error("the frame shows no bricks; expected the shaders that draw them to compile");
}

} // namespace osgLego
