#include "BookletRenderer.h"

#include "BookletFailure.h"

#include <string>

#include <osg/Quat>

namespace osgLego
{

namespace
{

const osg::Vec4 WHITE(1.0f, 1.0f, 1.0f, 1.0f);
constexpr double OUTLINE = 1.5; // pixels

/** Bricks as building instructions draw them, where equal parts look alike; each picture takes a third of the time of
 * one in the full look. */
BrickAppearance createDrawnAppearance()
{
    BrickAppearance appearance;
    appearance.outline = OUTLINE;
    appearance.joints = false;
    appearance.reliefHeight = 0.0;
    appearance.variation = 0.0;
    appearance.occlusion = BrickOcclusion::OFF;
    return appearance;
}

osg::ref_ptr<LegoNode> createNode()
{
    osg::ref_ptr<LegoNode> node = new LegoNode;
    node->setWaiting(true);
    return node;
}

/** The built-in sky, turned with the camera: a colour looks alike in all views. */
osg::ref_ptr<LightProbe> createSky(UpAxis up, const BookletCamera& camera)
{
    osg::ref_ptr<LightProbe> sky = new LightProbe;
    const osg::Quat upright = up == UpAxis::Y ? osg::Quat(-0.5 * osg::PI, osg::Vec3d(1, 0, 0)) : osg::Quat();
    sky->setRotation(upright * camera.getLightTurn());
    return sky;
}

} // namespace

BookletRenderer::BookletRenderer(osg::GraphicsContext& context) :
    _context(&context), _renderer(context), _occlusion(new AmbientOcclusionScene), _lego(createNode()),
    _base(createNode())
{
    _occlusion->addChild(_lego);
    _renderer.setScene(*_occlusion);
    setFullLook(false);
}

void BookletRenderer::setModel(const BrickModel& model, const BuildingPlan& plan)
{
    _model = &model;
    _lego->setStoredBricks(&model);
    _lego->setBuildingPlan(&plan);
}

/** Place the camera and, with it, the light. */
void BookletRenderer::place(const BookletCamera& camera, const BookletFrame& frame)
{
    camera.apply(_renderer.getCamera(), frame);
    const osg::ref_ptr<LightProbe> sky = createSky(_model->getGrid().upAxis, camera);
    _occlusion->setLightProbe(sky);
    for (LegoNode* node : {_lego.get(), _base.get()})
        node->setLightProbe(sky); // for pictures without ambient occlusion
}

/** Without bricks, the picture would be empty or show others. */
void BookletRenderer::checkDrawn() const
{
    const unsigned int contextID = _context->getState()->getContextID();
    for (const LegoNode* node : {_lego.get(), _base.get()})
        if (const std::string failure = node->getFailure(contextID); !failure.empty())
            throw BookletFailure(BookletError::Reason::NO_GL, "the pictures can't be drawn: " + failure);
}

void BookletRenderer::setBase(const BrickModel* base, osg::Node* table)
{
    _occlusion->removeChild(_table);
    _table = table;
    if (_table) _occlusion->addChild(_table);
    _occlusion->removeChild(_base);
    if (!base) return;
    _base->setStoredBricks(base);
    _occlusion->addChild(_base);
}

void BookletRenderer::setFullLook(bool isFull)
{
    _occlusion->setEnabled(isFull);
    for (LegoNode* node : {_lego.get(), _base.get()})
        node->setAppearance(isFull ? BrickAppearance() : createDrawnAppearance());
}

void BookletRenderer::setPlaced(std::size_t numPlaced, std::size_t numNew)
{
    _lego->setBuildProgress(static_cast<double>(numPlaced) / static_cast<double>(_model->getParts().size()));
    _lego->setNumNewParts(numNew);
}

osg::ref_ptr<osg::Image> BookletRenderer::draw(const BookletCamera& camera, const BookletFrame& frame,
                                               const glm::ivec2& size)
{
    place(camera, frame);
    osg::ref_ptr<osg::Image> picture = _renderer.draw(size, WHITE);
    checkDrawn();
    return picture;
}

osg::ref_ptr<osg::Image> BookletRenderer::drawTransparent(const BookletCamera& camera, const BookletFrame& frame,
                                                          const glm::ivec2& size)
{
    place(camera, frame);
    osg::ref_ptr<osg::Image> picture = _renderer.drawTransparent(size);
    checkDrawn();
    return picture;
}

} // namespace osgLego
