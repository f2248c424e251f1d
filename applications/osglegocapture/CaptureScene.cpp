#include "CaptureScene.h"

#include "ExitCode.h"

#include <common/RacingCar.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/Math>
#include <osg/Timer>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

namespace osgLego
{

namespace
{

constexpr double FIELD_OF_VIEW = 30.0; // degrees, of the picture's shorter side
constexpr int SAMPLES = 4;
const osg::Vec4 BACKGROUND(0.66f, 0.72f, 0.79f, 1.0f);

/** Finds the nodes of a class that a scene shows, but for those below one of them. */
template <typename Found>
class Finder : public osg::NodeVisitor
{
public:
    explicit Finder(osg::Node& scene) : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN) { scene.accept(*this); }

    void apply(osg::Group& group) override
    {
        if (auto* found = dynamic_cast<Found*>(&group))
            _all.push_back(found);
        else
            traverse(group);
    }

    /** The first one; null without any. */
    Found* getFound() const { return _all.empty() ? nullptr : _all.front(); }
    std::vector<Found*> getAll() const { return _all; }

private:
    std::vector<Found*> _all;
};

osg::ref_ptr<osg::Node> readMesh(const std::string& fileName)
{
    if (fileName.empty()) return createRacingCar();
    osgDB::ReaderWriter::ReadResult result =
        osgDB::Registry::instance()->readNode(fileName, osgDB::Registry::instance()->getOptions());
    if (result.validNode()) return result.getNode();
    // Pseudo-loaders lengthen the name of a file, so that only they can tell whether it is there.
    const bool isPlain =
        osgDB::findDataFile(fileName).empty() && osgDB::getLowerCaseFileExtension(fileName) != "legolize";
    const std::string why = !result.message().empty() ? result.message()
                            : isPlain                 ? "there is no such file"
                                                      : "OpenSceneGraph can't read it";
    throw CaptureError(EXIT_BAD_INPUT, "'" + fileName + "': " + why);
}

double elapsed(osg::Timer_t start)
{
    return osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
}

} // namespace

CaptureScene::CaptureScene(const CaptureOptions& options) : _options(options)
{
    const osg::Timer_t start = osg::Timer::instance()->tick();
    _source = readMesh(options.mesh);
    _readingTime = elapsed(start);
    prepare();
}

CaptureScene::CaptureScene(const CaptureOptions& options, const osg::ref_ptr<osg::Node>& node) :
    _options(options), _source(node)
{
    prepare();
}

void CaptureScene::prepare()
{
    // A pseudo-loader may have put a node around the mesh, or around a part of it, already.
    if (_options.original || _options.settings) unwrapSource();
    _shown = _source;
    if (_options.original) return;
    legolize();
    addOcclusion();
}

void CaptureScene::unwrapSource()
{
    const osg::ref_ptr<LegoNode> lego = Finder<LegoNode>(*_source).getFound();
    const auto* occlusion = dynamic_cast<AmbientOcclusionScene*>(_source.get());
    if (!lego || (lego != _source && !(occlusion && occlusion->containsNode(lego)))) return;
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (unsigned int child = 0; child < lego->getNumChildren(); ++child)
        group->addChild(lego->getChild(child));
    _source = group;
}

void CaptureScene::legolize()
{
    if (!_options.settings) _lego = Finder<LegoNode>(*_source).getFound();
    if (!_lego)
    {
        _lego = new LegoNode(_options.settings.value_or(LegoSettings()));
        _lego->addChild(_source);
        _shown = _lego;
    }
    if (!_lego->hasTriangles())
        throw CaptureError(EXIT_BAD_INPUT, "'" + _options.mesh + "' has no triangles to legolize");
    _lego->setWaiting(true);
    _lego->setTiming(!_options.statistics.empty());
    _lego->setReadBack(!_options.statistics.empty() || !_options.cells.empty());
}

void CaptureScene::addOcclusion()
{
    const osg::ref_ptr<LightProbe> probe = createProbe();
    for (LegoNode* lego : Finder<LegoNode>(*_shown).getAll())
        lego->setLightProbe(probe);
    _occlusion = Finder<AmbientOcclusionScene>(*_shown).getFound();
    if (_lego->getSettings().look == Look::FULL && _options.hasOcclusion && !_occlusion)
    {
        _occlusion = new AmbientOcclusionScene;
        _occlusion->addChild(_shown);
        _shown = _occlusion;
    }
    for (AmbientOcclusionScene* occlusion : Finder<AmbientOcclusionScene>(*_shown).getAll())
    {
        occlusion->setEnabled(_options.hasOcclusion);
        occlusion->setSettings(_options.occlusion);
        occlusion->setLightProbe(probe);
        occlusion->setTiming(!_options.statistics.empty());
    }
}

osg::ref_ptr<LightProbe> CaptureScene::createProbe() const
{
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    if (!_options.probe.file.empty())
    {
        std::string error;
        probe = LightProbe::read(_options.probe.file, error);
        if (!probe) throw CaptureError(EXIT_BAD_INPUT, error);
    }
    const osg::Quat turn(osg::DegreesToRadians(_options.probe.turn), osg::Vec3d(0, 0, 1));
    const osg::Quat upright = getUpAxis() == UpAxis::Y ? osg::Quat(-0.5 * osg::PI, osg::Vec3d(1, 0, 0)) : osg::Quat();
    probe->setRotation(turn * upright);
    probe->setIntensity(_options.probe.intensity);
    return probe;
}

osg::ref_ptr<osg::Image> CaptureScene::draw(osg::GraphicsContext& context)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(_options.width, _options.height, 1, GL_RGB, GL_UNSIGNED_BYTE);
    setUpCamera(context, *image);
    _viewer.realize();
    _viewer.frame();
    if (_lego) checkLegolized(*context.getState());

    // The picture is there; a second one only tells how long it takes when nothing is to be made anew.
    if (_options.statistics.empty()) return image;
    context.makeCurrent();
    glFinish();
    const osg::Timer_t start = osg::Timer::instance()->tick();
    _viewer.frame();
    context.makeCurrent();
    glFinish();
    _drawingTime = elapsed(start);
    return image;
}

void CaptureScene::checkLegolized(const osg::State& state) const
{
    const unsigned int contextID = state.getContextID();
    if (const std::string failure = _lego->getFailure(contextID); !failure.empty())
        throw CaptureError(LegoNode::isSupported(state) ? EXIT_BAD_INPUT : EXIT_NO_GL, failure);
    if (!_lego->isLegolized(contextID))
        throw CaptureError(EXIT_BAD_INPUT, "the scene does not draw its bricks; allowed: a level of detail, or a view, "
                                           "in which they are seen");
}

void CaptureScene::setUpCamera(osg::GraphicsContext& context, osg::Image& image)
{
    // The viewer's own camera draws nothing: the picture is made in a frame buffer object, so that its samples and
    // formats are the same whatever the context's own are.
    osg::Camera* window = _viewer.getCamera();
    window->setGraphicsContext(&context);
    window->setViewport(0, 0, context.getTraits()->width, context.getTraits()->height);
    window->setDrawBuffer(GL_FRONT);
    window->setReadBuffer(GL_FRONT);

    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->attach(osg::Camera::COLOR_BUFFER, &image, SAMPLES, SAMPLES);
    camera->setViewport(0, 0, _options.width, _options.height);
    camera->setClearColor(BACKGROUND);
    if (_options.view.near > 0.0) camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setCullingMode(osg::CullSettings::NO_CULLING); // bricks are made and counted however small they look
    placeCamera(*camera);
    camera->addChild(_shown);

    // A light over the left shoulder of this camera: head on, edges would drown.
    _viewer.setLightingMode(osg::View::NO_LIGHT);
    osg::ref_ptr<osg::LightSource> light = new osg::LightSource;
    light->setReferenceFrame(osg::LightSource::ABSOLUTE_RF);
    light->getLight()->setPosition(osg::Vec4(-0.35f, 0.55f, 1.0f, 0.0f));
    light->getLight()->setAmbient(osg::Vec4(0.0f, 0.0f, 0.0f, 1.0f));
    // The full look has light from all around besides.
    const bool isFull = _lego && _lego->getSettings().look == Look::FULL;
    const float diffuse = isFull ? 1.0f : 0.7f;
    light->getLight()->setDiffuse(osg::Vec4(diffuse, diffuse, diffuse, 1.0f));
    light->getLight()->setSpecular(osg::Vec4(1.0f, 1.0f, 1.0f, 1.0f));
    camera->addChild(light);
    camera->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::ON);
    camera->getStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::ON);
    osg::ref_ptr<osg::LightModel> ambient = new osg::LightModel;
    ambient->setAmbientIntensity(osg::Vec4(0.32f, 0.32f, 0.34f, 1.0f));
    camera->getOrCreateStateSet()->setAttribute(ambient);
    camera->getStateSet()->setMode(GL_MULTISAMPLE_ARB, osg::StateAttribute::ON);

    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setReleaseContextAtEndOfFrameHint(false);
    _viewer.setSceneData(camera);
}

void CaptureScene::placeCamera(osg::Camera& camera) const
{
    const bool isYUp = getUpAxis() == UpAxis::Y;
    const osg::Vec3d up = isYUp ? osg::Vec3d(0, 1, 0) : osg::Vec3d(0, 0, 1);
    const osg::Vec3d front = isYUp ? osg::Vec3d(0, 0, 1) : osg::Vec3d(0, -1, 0);
    const osg::Vec3d right(1, 0, 0);
    const double azimuth = osg::DegreesToRadians(_options.view.azimuth);
    const double elevation = osg::DegreesToRadians(_options.view.elevation);
    const osg::Vec3d ahead = front * std::cos(azimuth) + right * std::sin(azimuth);
    const osg::Vec3d toEye = ahead * std::cos(elevation) + up * std::sin(elevation);
    const osg::Vec3d headUp = up * std::cos(elevation) - ahead * std::sin(elevation);

    // Of the mesh, not of its bricks, so that pictures of both fit on each other.
    const bool isInSource = _lego && Finder<LegoNode>(*_source).getFound() == _lego;
    const osg::BoundingSphere bound = isInSource ? _lego->osg::Group::computeBound() : _source->getBound();
    const double halfView = osg::DegreesToRadians(0.5 * FIELD_OF_VIEW);
    const double radii = _options.view.distance > 0.0 ? _options.view.distance : 1.05 / std::sin(halfView);
    const double aspect = static_cast<double>(_options.width) / _options.height;
    const double vertical = aspect >= 1.0 ? halfView : std::atan(std::tan(halfView) / aspect);
    const double near =
        (_options.view.near > 0.0 ? _options.view.near : std::max(0.01, 0.5 * (radii - 2.0))) * bound.radius();
    const double far = (radii + 4.0) * bound.radius();
    if (_options.view.orthographic)
    {
        // What a perspective view shows in the middle, at the same size.
        const double height = std::tan(vertical) * radii * bound.radius();
        camera.setProjectionMatrixAsOrtho(-height * aspect, height * aspect, -height, height, near, far);
    }
    else
        camera.setProjectionMatrixAsPerspective(osg::RadiansToDegrees(2.0 * vertical), aspect, near, far);
    camera.setViewMatrixAsLookAt(osg::Vec3d(bound.center()) + toEye * (radii * bound.radius()), bound.center(), headUp);
}

UpAxis CaptureScene::getUpAxis() const
{
    if (_options.settings) return _options.settings->upAxis;
    return _lego ? _lego->getSettings().upAxis : UpAxis::Z;
}

} // namespace osgLego
