#include <osgLego/occlusion/ScreenPass.h>

#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/StateOverride.h>

#include <osg/CullFace>
#include <osg/PolygonMode>
#include <osg/RenderInfo>
#include <osg/Timer>
#include <osg/Uniform>

namespace osgLego
{

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

void ScreenPass::setTargets(const std::vector<osg::ref_ptr<osg::Texture2D>>& targets, const osg::Vec4& clearColor)
{
    _camera = new PassCamera(*this, targets, clearColor);
    _camera->setRenderOrder(osg::Camera::PRE_RENDER, RENDER_ORDER);
    applyInitialState(*getStateSet());
}

osg::Node& ScreenPass::getNode()
{
    if (_camera) return *_camera;
    return *this;
}

void ScreenPass::setView(const osg::RefMatrix& projection, const osg::Matrixd& eyeToWorld, const glm::ivec2& origin,
                         const glm::ivec2& size)
{
    _projection = &projection;
    _eyeToWorld = rotationOf(eyeToWorld);
    _origin = origin;
    _size = size;
}

void ScreenPass::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    if (!state.getLastAppliedProgramObject() || !_projection) return;
    if ((_source && _source->hasFailed()) || (_camera && !isTargetThere(state))) return;
    const osg::Timer_t start = osg::Timer::instance()->tick();
    const ProgramUniforms uniforms(state);
    uniforms.set("sceneProjection", toGlsl(*_projection));
    uniforms.set("pixelSize", 2.0f / glm::vec2(_size));
    uniforms.set("origin", _origin);
    uniforms.set("eyeToWorld", _eyeToWorld);
    setFog(uniforms, state);
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (!_timing) return;
    glFinish();
    _time = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
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
