#include "BenchView.h"

#include <common/RacingCar.h>

#include <offscreen/OffscreenContext.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Math>
#include <osg/ShapeDrawable>
#include <osgDB/ReadFile>

namespace osgLego
{

namespace
{

constexpr double FIELD_OF_VIEW = 30.0;

/** Ten steps up, each one brick high and deep at a resolution of 10. */
osg::ref_ptr<osg::Node> createStair()
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (int step = 0; step < 10; ++step)
    {
        const auto height = static_cast<float>(step + 1);
        osg::ref_ptr<osg::ShapeDrawable> box = new osg::ShapeDrawable(new osg::Box(
            osg::Vec3(5.0f, static_cast<float>(step) + 0.5f, 0.5f * height), 9.98f, 0.98f, height - 0.02f));
        box->setColor(osg::Vec4(0.8f, 0.8f, 0.8f, 1.0f));
        geode->addDrawable(box);
    }
    return geode;
}

} // namespace

BenchScene createBenchScene(const MeshSource& source, unsigned int resolution)
{
    BenchScene scene;
    scene.name = source.name;
    scene.mesh = source.path;
    scene.settings.resolution = resolution;
    scene.settings.upAxis = source.upAxis;
    return scene;
}

osg::ref_ptr<osg::Node> createBenchMesh(const std::string& name)
{
    if (name.empty()) return createRacingCar();
    if (name == "stair") return createStair();
    osg::ref_ptr<osg::Node> mesh = osgDB::readRefNodeFile(name);
    if (!mesh) throw std::runtime_error("can't read '" + name + "'");
    return mesh;
}

void placeCamera(osg::Camera& camera, const BenchScene& scene, const osg::BoundingSphere& bound, double aspectRatio)
{
    const bool isYUp = scene.settings.upAxis == UpAxis::Y;
    const osg::Vec3d up = isYUp ? osg::Vec3d(0, 1, 0) : osg::Vec3d(0, 0, 1);
    const osg::Vec3d front = isYUp ? osg::Vec3d(0, 0, 1) : osg::Vec3d(0, -1, 0);
    const double azimuth = osg::DegreesToRadians(scene.azimuth);
    const double elevation = osg::DegreesToRadians(scene.elevation);
    const osg::Vec3d ahead = front * std::cos(azimuth) + osg::Vec3d(std::sin(azimuth), 0, 0);
    const osg::Vec3d toEye = ahead * std::cos(elevation) + up * std::sin(elevation);
    const double distance = scene.distance * bound.radius();
    camera.setProjectionMatrixAsPerspective(FIELD_OF_VIEW, aspectRatio, 0.05 * distance,
                                            distance + 4.0 * bound.radius());
    camera.setViewMatrixAsLookAt(osg::Vec3d(bound.center()) + toEye * distance, bound.center(), up);
}

BenchView::BenchView(const BenchScene& scene, const glm::ivec2& size, PictureUse use) :
    _size(size), _lego(new LegoNode(scene.settings)), _scene(new AmbientOcclusionScene), _camera(new osg::Camera),
    _image(new osg::Image)
{
    std::string error;
    const osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(16, 16, error);
    if (!context) throw std::runtime_error(error);
    _lego->addChild(createBenchMesh(scene.mesh));
    _scene->addChild(_lego);
    if (!_lego->hasTriangles()) throw std::runtime_error("'" + scene.mesh + "' has no triangles");

    _viewer.getCamera()->setGraphicsContext(context);
    _viewer.getCamera()->setViewport(0, 0, 16, 16);
    _viewer.getCamera()->setDrawBuffer(GL_FRONT);
    _viewer.getCamera()->setReadBuffer(GL_FRONT);
    _camera->setRenderOrder(osg::Camera::PRE_RENDER);
    _camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    attachTarget(use);
    _camera->setViewport(0, 0, size.x, size.y);
    _camera->setClearColor(osg::Vec4());
    _camera->setCullingMode(osg::CullSettings::NO_CULLING);
    _camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    _camera->addChild(_scene);
    placeCamera(*_camera, scene, _lego->getBound(), static_cast<double>(size.x) / size.y);
    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setReleaseContextAtEndOfFrameHint(false);
    _viewer.setSceneData(_camera);
    _viewer.realize();
}

void BenchView::attachTarget(PictureUse use)
{
    if (use == PictureUse::DISCARD)
    {
        _camera->attach(osg::Camera::COLOR_BUFFER, static_cast<GLenum>(GL_RGBA32F_ARB));
        return;
    }
    _image->allocateImage(_size.x, _size.y, 1, GL_RGBA, GL_FLOAT);
    _image->setInternalTextureFormat(GL_RGBA32F_ARB);
    _camera->attach(osg::Camera::COLOR_BUFFER, _image);
}

void BenchView::drawFrame(const AmbientOcclusionSettings& settings)
{
    _scene->setSettings(settings);
    getContext().makeCurrent(); // another view's may be, which a viewer does not notice
    _viewer.frame();
    glFinish();
    const std::string failure = _lego->getFailure(getContextID());
    if (!failure.empty()) throw std::runtime_error(failure);
}

osg::ref_ptr<osg::Image> BenchView::draw(const AmbientOcclusionSettings& settings)
{
    drawFrame(settings);
    return new osg::Image(*_image, osg::CopyOp::DEEP_COPY_ALL);
}

void BenchView::getRay(const glm::ivec2& pixel, osg::Vec3d& origin, osg::Vec3d& direction) const
{
    const osg::Matrixd toModel = osg::Matrixd::inverse(_camera->getViewMatrix() * _camera->getProjectionMatrix());
    const double x = 2.0 * (pixel.x + 0.5) / _size.x - 1.0;
    const double y = 2.0 * (pixel.y + 0.5) / _size.y - 1.0;
    origin = osg::Vec3d(x, y, -1.0) * toModel;
    direction = osg::Vec3d(x, y, 1.0) * toModel - origin;
    direction.normalize();
}

osg::Vec3d BenchView::toModel(const osg::Vec3d& eyeDirection) const
{
    return osg::Matrixd::transform3x3(eyeDirection, _camera->getInverseViewMatrix());
}

AmbientOcclusionTimes BenchView::getTimes() const
{
    return _scene->getTimes(getContextID());
}

LegoStatistics BenchView::getStatistics() const
{
    return _lego->getStatistics(getContextID());
}

} // namespace osgLego
