#include "BookletRenderer.h"

#include <vector>

#include <osg/Quat>

namespace osgLego
{

namespace
{

const osg::Vec4 WHITE(1.0f, 1.0f, 1.0f, 1.0f);
constexpr double OUTLINE = 2.0; // pixels

osg::ref_ptr<LegoNode> createNode()
{
    osg::ref_ptr<LegoNode> node = new LegoNode;
    node->setWaiting(true);
    BrickAppearance appearance;
    appearance.outline = OUTLINE;
    appearance.variation = 0.0; // equal parts look alike in lists and steps
    node->setAppearance(appearance);
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
    _renderer(context), _occlusion(new AmbientOcclusionScene), _lego(createNode()), _base(createNode())
{
    _occlusion->addChild(_lego);
    _renderer.setScene(*_occlusion);
}

void BookletRenderer::setModel(const BrickModel& model, const BuildingPlan& plan)
{
    _model = &model;
    _plan = &plan;
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

void BookletRenderer::setBase(const BrickModel* base)
{
    _occlusion->removeChild(_base);
    if (!base) return;
    _base->setStoredBricks(base);
    _occlusion->addChild(_base);
}

void BookletRenderer::setOcclusion(bool hasOcclusion)
{
    _occlusion->setEnabled(hasOcclusion);
}

void BookletRenderer::setPlaced(std::size_t numPlaced, std::size_t numNew)
{
    _lego->setBuildProgress(static_cast<double>(numPlaced) / static_cast<double>(_model->getParts().size()));
    _lego->setNumNewParts(numNew);
    _numPlaced = numPlaced;
    _numNew = numNew;
}

osg::ref_ptr<osg::Image> BookletRenderer::draw(const BookletCamera& camera, const BookletFrame& frame,
                                               const glm::ivec2& size)
{
    place(camera, frame);
    return _renderer.draw(size, WHITE);
}

osg::ref_ptr<osg::Image> BookletRenderer::drawNewParts(const BookletCamera& camera, const BookletFrame& frame,
                                                       const glm::ivec2& size, const std::array<std::uint8_t, 3>& color)
{
    const auto first = _plan->getOrder().begin() + static_cast<std::ptrdiff_t>(_numPlaced - _numNew);
    const std::vector<std::size_t> parts(first, first + static_cast<std::ptrdiff_t>(_numNew));
    _lego->setHighlightedParts(parts, color);
    osg::ref_ptr<osg::Image> picture = draw(camera, frame, size);
    _lego->setHighlightedParts({}, color);
    return picture;
}

osg::ref_ptr<osg::Image> BookletRenderer::drawTransparent(const BookletCamera& camera, const BookletFrame& frame,
                                                          const glm::ivec2& size)
{
    place(camera, frame);
    return _renderer.drawTransparent(size);
}

} // namespace osgLego
