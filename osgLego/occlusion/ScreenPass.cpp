#include <osgLego/occlusion/ScreenPass.h>

#include <osgLego/gl/CoreVertexArray.h>
#include <osgLego/gl/FixedState.h>
#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/StateOverride.h>
#include <osgLego/polygonization/PictureTiles.h>

#include <glm/vec4.hpp>
#include <osg/BoundingBox>
#include <osg/CullFace>
#include <osg/PolygonMode>
#include <osg/RenderInfo>
#include <osg/Timer>
#include <osg/Uniform>
#include <osg/Viewport>

namespace osgLego
{

namespace
{

constexpr unsigned int TILES_UNIT = 8; // above the inputs of every pass and the maps of light probes

void setViewport(osg::Camera& camera, const PictureArea& area)
{
    const glm::ivec2 size = area.getSize();
    const osg::Viewport& present = *camera.getViewport();
    // Replaced rather than changed: the frame that is being drawn may still use it.
    if (present.x() != area.begin.x || present.y() != area.begin.y || present.width() != size.x ||
        present.height() != size.y)
        camera.setViewport(new osg::Viewport(area.begin.x, area.begin.y, size.x, size.y));
}

} // namespace

ScreenPass::ScreenPass(osg::Program& program, const std::vector<Input>& inputs)
{
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setCullingActive(false);
    setDataVariance(osg::Object::STATIC);
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    stateSet->setAttributeAndModes(&program, osg::StateAttribute::ON | OVERRIDE_PROTECTED);
    stateSet->setAttribute(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::FILL),
                           OVERRIDE_PROTECTED);
    for (const auto mode : {GL_CULL_FACE, GL_ALPHA_TEST, GL_POLYGON_OFFSET_FILL, GL_CLIP_PLANE0, GL_CLIP_PLANE1,
                            GL_CLIP_PLANE2, GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5})
        stateSet->setMode(static_cast<osg::StateAttribute::GLMode>(mode),
                          osg::StateAttribute::OFF | OVERRIDE_PROTECTED);
    for (std::size_t unit = 0; unit < inputs.size(); ++unit)
    {
        stateSet->setTextureAttribute(static_cast<unsigned int>(unit), inputs[unit].texture, OVERRIDE_PROTECTED);
        stateSet->addUniform(new osg::Uniform(inputs[unit].name, static_cast<int>(unit)));
    }
    setStateSet(stateSet);
}

void ScreenPass::setTargets(const std::vector<osg::ref_ptr<osg::Texture2D>>& targets, const osg::Vec4& clearColor,
                            int pixelsPerTexel)
{
    _pixelsPerTexel = pixelsPerTexel;
    _camera = new PassCamera(*this, targets, clearColor);
    _camera->setRenderOrder(osg::Camera::PRE_RENDER, RENDER_ORDER);
    applyInitialState(*getStateSet());
}

void ScreenPass::setTiles(osg::Texture2D& tiles)
{
    _drawsTiles = true;
    osg::StateSet& stateSet = *getStateSet();
    stateSet.setTextureAttribute(TILES_UNIT, &tiles, OVERRIDE_PROTECTED);
    stateSet.addUniform(new osg::Uniform("tiles", static_cast<int>(TILES_UNIT)));
    setPointModes(stateSet);
}

osg::Node& ScreenPass::getNode()
{
    if (_camera) return *_camera;
    return *this;
}

void ScreenPass::setView(const PassView& view)
{
    _view = view;
    if (_camera) setViewport(*_camera, view.area.dividedBy(_pixelsPerTexel));
    if (_camera || (_bound.center() == view.bound.center() && _bound.radius() == view.bound.radius())) return;
    _bound = view.bound;
    osg::BoundingBox box;
    box.expandBy(_bound);
    setInitialBound(box);
}

void ScreenPass::cull(osgUtil::CullVisitor& visitor)
{
    // The children determine the near and far planes, and their bounds are smaller than that of the group.
    const osg::CullSettings::ComputeNearFarMode mode = visitor.getComputeNearFarMode();
    visitor.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    getNode().accept(visitor);
    visitor.setComputeNearFarMode(mode);
}

void ScreenPass::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    if (!state.getLastAppliedProgramObject() || !_view.projection) return;
    if ((_source && _source->hasFailed()) || (_camera && !isTargetThere(state))) return;
    const osg::Timer_t start = osg::Timer::instance()->tick();
    const ProgramUniforms uniforms(state);
    const PictureArea& area = _view.area;
    uniforms.set("sceneProjection", toGlsl(*_view.projection));
    uniforms.set("pixelSize", 2.0f / glm::vec2(_view.size));
    uniforms.set("origin", _view.origin);
    uniforms.set("eyeToWorld", _view.eyeToWorld);
    uniforms.set("area", glm::ivec4(area.begin, area.end - 1));
    setFog(uniforms, state);
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    const CoreVertexArray vertexArray(state);
    draw(uniforms);
    if (!_timing) return;
    glFinish();
    _time = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
}

void ScreenPass::draw(const ProgramUniforms& uniforms) const
{
    if (!_drawsTiles)
    {
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        return;
    }
    const glm::ivec2 size = _view.area.getSize();
    uniforms.set("viewport",
                 _camera ? glm::ivec4(_view.area.begin, size) : glm::ivec4(0, 0, _view.size.x, _view.size.y));
    const glm::ivec2 count = _view.area.dividedBy(PictureTiles::SIDE).getSize();
    glDrawArrays(GL_POINTS, 0, count.x * count.y);
}

void ScreenPass::resizeGLObjectBuffers(unsigned int maxSize)
{
    osg::Drawable::resizeGLObjectBuffers(maxSize);
    if (_camera) _camera->resizeGLObjectBuffers(maxSize);
}

void ScreenPass::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    if (_camera) _camera->releaseGLObjects(state);
}

} // namespace osgLego
