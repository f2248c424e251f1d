#include "BookletRenderer.h"

#include <osg/Quat>

namespace osgLego
{

namespace
{

const osg::Vec4 WHITE(1.0f, 1.0f, 1.0f, 1.0f);
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
    _renderer(context), _occlusion(new AmbientOcclusionScene), _lego(new LegoNode)
{
    _lego->setWaiting(true);
    BrickAppearance appearance;
    appearance.outline = OUTLINE;
    appearance.variation = 0.0; // equal parts look alike in lists and steps
    _lego->setAppearance(appearance);
    _occlusion->addChild(_lego);
    _renderer.setScene(*_occlusion);
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
    place.apply(_renderer.getCamera(), frame);
    return _renderer.draw(size, WHITE);
}

osg::ref_ptr<osg::Image> BookletRenderer::drawTransparent(const BookletCamera& place, const BookletFrame& frame,
                                                          const glm::ivec2& size)
{
    place.apply(_renderer.getCamera(), frame);
    return _renderer.drawTransparent(size);
}

} // namespace osgLego
