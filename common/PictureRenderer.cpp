#include "PictureRenderer.h"

#include "PictureTransparency.h"

#include <osgLego/LegoNode.h>

#include <osg/GLObjects>
#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/Timer>

namespace osgLego
{

namespace
{

const osg::Vec4 BLACK(0.0f, 0.0f, 0.0f, 1.0f);
const osg::Vec4 WHITE(1.0f, 1.0f, 1.0f, 1.0f);
// Seconds: an animation shows the same moment in all frames of a picture, however long they take.
constexpr double SIMULATION_TIME = 0.0;

} // namespace

std::string PictureRenderer::findMissing(osg::GraphicsContext& context)
{
    context.makeCurrent();
    std::string missing = LegoNode::getMissing(*context.getState());
    context.releaseContext();
    return missing;
}

PictureRenderer::PictureRenderer(osg::GraphicsContext& context, int samples) :
    _context(&context), _camera(new osg::Camera), _samples(static_cast<unsigned int>(samples > 1 ? samples : 0))
{
    // The viewer's own camera draws nothing.
    osg::Camera* window = _viewer.getCamera();
    window->setGraphicsContext(&context);
    window->setViewport(0, 0, context.getTraits()->width, context.getTraits()->height);
    window->setDrawBuffer(GL_NONE);
    window->setReadBuffer(GL_NONE);

    _camera->setRenderOrder(osg::Camera::PRE_RENDER);
    _camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    _camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    _camera->setCullingMode(osg::CullSettings::NO_CULLING); // bricks are made and counted even if they are small
    addLight();

    _viewer.setLightingMode(osg::View::NO_LIGHT);
    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setReleaseContextAtEndOfFrameHint(false);
    _viewer.setSceneData(_camera);
}

PictureRenderer::~PictureRenderer()
{
    _context->makeCurrent();
    // A frame that ended with an exception has left the state sets of the scene, which may be deleted before the
    // context.
    if (_context->getState()->getStateSetStackSize() > 0) _context->getState()->popAllStateSets();
    _camera->releaseGLObjects(_context->getState());
    osg::flushAllDeletedGLObjects(_context->getState()->getContextID());
    _context->releaseContext();
    // A viewer closes the contexts of its cameras.
    _viewer.getCamera()->setGraphicsContext(nullptr);
}

/** With a headlight, edges would hardly be visible. */
void PictureRenderer::addLight()
{
    osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
    source->setReferenceFrame(osg::LightSource::ABSOLUTE_RF);
    _light = source->getLight();
    _light->setPosition(osg::Vec4(-0.35f, 0.55f, 1.0f, 0.0f));
    _light->setAmbient(BLACK);
    _light->setSpecular(WHITE);
    setBrightness(1.0f);
    _camera->addChild(source);
    osg::StateSet* state = _camera->getOrCreateStateSet();
    osg::ref_ptr<osg::LightModel> ambient = new osg::LightModel;
    ambient->setAmbientIntensity(osg::Vec4(0.32f, 0.32f, 0.34f, 1.0f));
    state->setAttribute(ambient);
    state->setMode(GL_LIGHTING, osg::StateAttribute::ON);
    state->setMode(GL_LIGHT0, osg::StateAttribute::ON);
    state->setMode(GL_MULTISAMPLE_ARB, osg::StateAttribute::ON);
}

void PictureRenderer::setScene(osg::Node& scene)
{
    if (_scene) _camera->removeChild(_scene);
    _scene = &scene;
    _camera->insertChild(0, _scene);
}

void PictureRenderer::setBrightness(float brightness)
{
    _light->setDiffuse(osg::Vec4(brightness, brightness, brightness, 1.0f));
}

osg::ref_ptr<osg::Image> PictureRenderer::draw(const glm::ivec2& size, const osg::Vec4& background)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(size.x, size.y, 1, GL_RGB, GL_UNSIGNED_BYTE);
    _camera->setClearColor(background);
    _camera->setViewport(0, 0, size.x, size.y);
    _camera->attach(osg::Camera::COLOR_BUFFER, image, _samples, _samples);
    // The frame buffer object of the last picture may have another size.
    _camera->setRenderingCache(nullptr);
    _camera->dirtyAttachmentMap();
    _viewer.realize();
    _viewer.frame(SIMULATION_TIME);
    return image;
}

/** Uses pictures over two backgrounds, since the alpha in a frame buffer belongs to the surfaces, whether blended or
 * not; it does not tell how much of the background they hide. */
osg::ref_ptr<osg::Image> PictureRenderer::drawTransparent(const glm::ivec2& size)
{
    const osg::ref_ptr<osg::Image> overBlack = draw(size, BLACK);
    return makeTransparent(*overBlack, *draw(size, WHITE));
}

double PictureRenderer::timeFrame()
{
    _context->makeCurrent();
    glFinish();
    const osg::Timer_t start = osg::Timer::instance()->tick();
    _viewer.frame(SIMULATION_TIME);
    _context->makeCurrent();
    glFinish();
    return osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
}

} // namespace osgLego
