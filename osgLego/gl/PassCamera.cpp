#include <osgLego/gl/PassCamera.h>

#include <osgLego/gl/StateOverride.h>

#include <osg/BlendEquation>
#include <osg/ColorMask>
#include <osg/GLExtensions>
#include <osg/NodeVisitor>
#include <osg/Point>
#include <osg/Viewport>

namespace osgLego
{

PassCamera::PassCamera(const osg::Drawable& drawable, osg::Texture2D& target, const osg::Vec4& clearColor) :
    PassCamera(drawable, std::vector<osg::ref_ptr<osg::Texture2D>>{&target}, clearColor)
{
}

PassCamera::PassCamera(const osg::Drawable& drawable, const std::vector<osg::ref_ptr<osg::Texture2D>>& targets,
                       const osg::Vec4& clearColor) :
    _drawable(drawable)
{
    if (targets.size() == 1)
        attach(COLOR_BUFFER, targets.front());
    else
        for (std::size_t index = 0; index < targets.size(); ++index)
            attach(static_cast<BufferComponent>(COLOR_BUFFER0 + index), targets[index]);
    setUp({targets.front()->getTextureWidth(), targets.front()->getTextureHeight()});
    setClearColor(clearColor);
    setClearMask(GL_COLOR_BUFFER_BIT);
}

PassCamera::PassCamera(const osg::Drawable& drawable) : _drawable(drawable)
{
    attach(COLOR_BUFFER, GL_RGBA8);
    setUp({1, 1});
    setClearMask(0);
}

void PassCamera::setUp(const glm::ivec2& size)
{
    setRenderOrder(PRE_RENDER);
    setRenderTargetImplementation(FRAME_BUFFER_OBJECT);
    setImplicitBufferAttachmentMask(0, 0);
    setReferenceFrame(ABSOLUTE_RF);
    setViewport(0, 0, size.x, size.y);
    setColorMask(true, true, true, true);
    setCullingMode(NO_CULLING);
    setComputeNearFarMode(DO_NOT_COMPUTE_NEAR_FAR);
    setCullMask(~0u);
    setInheritanceMask(getInheritanceMask() & ~(CULL_MASK | COMPUTE_NEAR_FAR_MODE | CULLING_MODE));
    setCullingActive(false);
    setAllowEventFocus(false);
}

void PassCamera::traverse(osg::NodeVisitor& visitor)
{
    if (visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR)
        const_cast<osg::Drawable&>(_drawable).accept(visitor);
}

osg::ref_ptr<osg::Texture2D> PassCamera::createTarget(const glm::ivec2& size)
{
    osg::ref_ptr<osg::Texture2D> target = new osg::Texture2D;
    target->setTextureSize(size.x, size.y);
    target->setInternalFormat(GL_RGBA32F_ARB);
    target->setSourceFormat(GL_RGBA);
    target->setSourceType(GL_FLOAT);
    target->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    target->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    target->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    target->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return target;
}

bool PassCamera::isTargetThere(const osg::State& state)
{
    GLint name = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    return name != 0 && extensions.glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

osg::ref_ptr<osg::StateSet> PassCamera::createStateSet(osg::Program& program)
{
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    stateSet->setAttributeAndModes(&program, osg::StateAttribute::ON | OVERRIDE_PROTECTED);
    applyInitialState(*stateSet);
    return stateSet;
}

void PassCamera::applyInitialState(osg::StateSet& stateSet)
{
    stateSet.setAttribute(new osg::Point(1.0f), OVERRIDE_PROTECTED);
    stateSet.setAttribute(new osg::ColorMask, OVERRIDE_PROTECTED);
    stateSet.setAttribute(new osg::BlendEquation(osg::BlendEquation::FUNC_ADD), OVERRIDE_PROTECTED);
    for (const auto mode :
         {GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_ALPHA_TEST, GL_SCISSOR_TEST, GL_COLOR_LOGIC_OP, GL_POINT_SMOOTH,
          GL_POINT_SPRITE_ARB, GL_VERTEX_PROGRAM_POINT_SIZE, GL_SAMPLE_ALPHA_TO_COVERAGE_ARB, GL_DITHER, GL_FOG,
          GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE2, GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5})
        stateSet.setMode(static_cast<osg::StateAttribute::GLMode>(mode), osg::StateAttribute::OFF | OVERRIDE_PROTECTED);
}

} // namespace osgLego
