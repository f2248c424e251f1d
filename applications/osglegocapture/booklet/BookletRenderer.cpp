#include "BookletRenderer.h"

#include "../ExitCode.h"
#include "../Transparency.h"

#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/Quat>

namespace osgLego
{

namespace
{

const osg::Vec4 BLACK(0.0f, 0.0f, 0.0f, 1.0f);
const osg::Vec4 WHITE(1.0f, 1.0f, 1.0f, 1.0f);
constexpr unsigned int SAMPLES = 4;
constexpr double OUTLINE = 2.0; // pixels

/** The built-in sky. @param isUpsideDown whether it is below the model. */
osg::ref_ptr<LightProbe> createSky(UpAxis up, bool isUpsideDown)
{
    osg::ref_ptr<LightProbe> sky = new LightProbe;
    const osg::Quat over(isUpsideDown ? osg::PI : 0.0, osg::Vec3d(0, 1, 0)); // about the front of the model
    const osg::Quat upright = up == UpAxis::Y ? osg::Quat(-0.5 * osg::PI, osg::Vec3d(1, 0, 0)) : osg::Quat();
    sky->setRotation(over * upright);
    return sky;
}

} // namespace

BookletRenderer::BookletRenderer(osg::GraphicsContext& context) :
    _camera(new osg::Camera), _occlusion(new AmbientOcclusionScene), _lego(new LegoNode)
{
    checkSupport(context);
    // The viewer's own camera draws nothing: pictures of any size are drawn into frame buffer objects.
    osg::Camera* window = _viewer.getCamera();
    window->setGraphicsContext(&context);
    window->setViewport(0, 0, context.getTraits()->width, context.getTraits()->height);
    window->setDrawBuffer(GL_FRONT);
    window->setReadBuffer(GL_FRONT);

    _camera->setRenderOrder(osg::Camera::PRE_RENDER);
    _camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setCullingMode(osg::CullSettings::NO_CULLING);
    _lego->setWaiting(true);
    BrickAppearance appearance;
    appearance.outline = OUTLINE;
    appearance.variation = 0.0; // equal parts look alike in lists and steps
    _lego->setAppearance(appearance);
    _occlusion->addChild(_lego);
    _camera->addChild(_occlusion);
    addLight();

    _viewer.setLightingMode(osg::View::NO_LIGHT);
    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setReleaseContextAtEndOfFrameHint(false);
    _viewer.setSceneData(_camera);
    _viewer.realize();
}

/** Called before drawing: otherwise OSG would report every shader that an unsupported context can't compile. */
void BookletRenderer::checkSupport(osg::GraphicsContext& context) const
{
    context.makeCurrent();
    const std::string missing = LegoNode::getMissing(*context.getState());
    context.releaseContext();
    if (!missing.empty()) throw CaptureError(EXIT_NO_GL, missing);
}

/** A light above the left of the camera, whatever the view is, so that all pictures have the same shades. */
void BookletRenderer::addLight()
{
    osg::ref_ptr<osg::LightSource> light = new osg::LightSource;
    light->setReferenceFrame(osg::LightSource::ABSOLUTE_RF);
    light->getLight()->setPosition(osg::Vec4(-0.35f, 0.55f, 1.0f, 0.0f));
    light->getLight()->setAmbient(BLACK);
    light->getLight()->setDiffuse(WHITE);
    light->getLight()->setSpecular(WHITE);
    _camera->addChild(light);
    osg::StateSet* state = _camera->getOrCreateStateSet();
    osg::ref_ptr<osg::LightModel> ambient = new osg::LightModel;
    ambient->setAmbientIntensity(osg::Vec4(0.32f, 0.32f, 0.34f, 1.0f));
    state->setAttribute(ambient);
    state->setMode(GL_LIGHTING, osg::StateAttribute::ON);
    state->setMode(GL_LIGHT0, osg::StateAttribute::ON);
    state->setMode(GL_MULTISAMPLE_ARB, osg::StateAttribute::ON);
}

void BookletRenderer::setModel(const BrickModel& model, const BuildingPlan& plan)
{
    _model = &model;
    _lego->setStoredBricks(&model);
    _lego->setBuildingPlan(&plan);
}

void BookletRenderer::setUpsideDown(bool isUpsideDown)
{
    const osg::ref_ptr<LightProbe> sky = createSky(_model->getGrid().upAxis, isUpsideDown);
    _occlusion->setLightProbe(sky);
    _lego->setLightProbe(sky); // for pictures without ambient occlusion
}

void BookletRenderer::setOcclusion(bool hasOcclusion)
{
    _occlusion->setEnabled(hasOcclusion);
}

void BookletRenderer::setPlaced(std::size_t numPlaced, std::size_t numNew)
{
    _lego->setBuildProgress(static_cast<double>(numPlaced) / static_cast<double>(_model->getParts().size()));
    _lego->setNumNewParts(numNew);
}

osg::ref_ptr<osg::Image> BookletRenderer::draw(const BookletCamera& place, const BookletFrame& frame,
                                               const glm::ivec2& size)
{
    place.apply(*_camera, frame);
    return drawOver(WHITE, size);
}

osg::ref_ptr<osg::Image> BookletRenderer::drawTransparent(const BookletCamera& place, const BookletFrame& frame,
                                                          const glm::ivec2& size)
{
    place.apply(*_camera, frame);
    const osg::ref_ptr<osg::Image> overBlack = drawOver(BLACK, size);
    return makeTransparent(*overBlack, *drawOver(WHITE, size));
}

osg::ref_ptr<osg::Image> BookletRenderer::drawOver(const osg::Vec4& background, const glm::ivec2& size)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(size.x, size.y, 1, GL_RGB, GL_UNSIGNED_BYTE);
    _camera->setClearColor(background);
    _camera->setViewport(0, 0, size.x, size.y);
    _camera->attach(osg::Camera::COLOR_BUFFER, image, SAMPLES, SAMPLES);
    // The frame buffer object of the last picture has another size.
    _camera->setRenderingCache(nullptr);
    _camera->dirtyAttachmentMap();
    _viewer.frame();
    return image;
}

} // namespace osgLego
