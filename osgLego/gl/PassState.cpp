#include <osgLego/gl/PassState.h>

#include <osgLego/gl/GlRequirements.h>
#include <osgLego/gl/StateOverride.h>

#include <osg/BlendEquation>
#include <osg/ColorMask>
#include <osg/GLExtensions>
#include <osg/Point>
#include <osg/PolygonMode>

namespace osgLego
{

namespace
{

/** Points of the size 1. Contexts of the core profile have none of the other parameters of osg::Point. */
class SmallPoint : public osg::Point
{
public:
    SmallPoint() : osg::Point(1.0f) {}

    void apply(osg::State& state) const override
    {
        if (GlRequirements::isCore(state))
            glPointSize(getSize());
        else
            osg::Point::apply(state);
    }

private:
    ~SmallPoint() override = default;
};

} // namespace

bool isTargetThere(const osg::State& state)
{
    GLint name = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    return name != 0 && extensions.glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

osg::ref_ptr<osg::StateSet> createPassState(osg::Program& program)
{
    osg::ref_ptr<osg::StateSet> stateSet = new osg::StateSet;
    stateSet->setAttributeAndModes(&program, osg::StateAttribute::ON | OVERRIDE_PROTECTED);
    applyInitialState(*stateSet);
    return stateSet;
}

void applyInitialState(osg::StateSet& stateSet)
{
    stateSet.setAttribute(new SmallPoint, OVERRIDE_PROTECTED);
    stateSet.setAttribute(new osg::ColorMask, OVERRIDE_PROTECTED);
    stateSet.setAttribute(new osg::BlendEquation(osg::BlendEquation::FUNC_ADD), OVERRIDE_PROTECTED);
    for (const auto mode :
         {GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_ALPHA_TEST, GL_SCISSOR_TEST, GL_COLOR_LOGIC_OP, GL_POINT_SMOOTH,
          GL_POINT_SPRITE_ARB, GL_VERTEX_PROGRAM_POINT_SIZE, GL_SAMPLE_ALPHA_TO_COVERAGE_ARB, GL_DITHER, GL_FOG,
          GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE2, GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5})
        stateSet.setMode(static_cast<osg::StateAttribute::GLMode>(mode), osg::StateAttribute::OFF | OVERRIDE_PROTECTED);
}

void setPointModes(osg::StateSet& stateSet)
{
    stateSet.setAttribute(new osg::PolygonMode, OVERRIDE_PROTECTED);
    // Point sprites have the exact size; the size of other points is rounded.
    for (const auto mode : {GL_POINT_SPRITE_ARB, GL_VERTEX_PROGRAM_POINT_SIZE})
        stateSet.setMode(static_cast<osg::StateAttribute::GLMode>(mode), osg::StateAttribute::ON | OVERRIDE_PROTECTED);
}

} // namespace osgLego
