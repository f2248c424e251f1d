#include "GlRestoration.h"

#include <osg/GraphicsContext>
#include <osg/Texture>

namespace osgLego
{

GlRestoration::GlRestoration(osg::State& state) : _state(state)
{
    state.setActiveTextureUnit(0);
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    for (const int mode : {GL_ALPHA_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER,
                           GL_SCISSOR_TEST, GL_STENCIL_TEST})
        glDisable(static_cast<GLenum>(mode));
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

GlRestoration::~GlRestoration()
{
    const osg::GLExtensions& extensions = *_state.get<osg::GLExtensions>();
    const osg::GraphicsContext* context = _state.getGraphicsContext();
    extensions.glBindFramebuffer(GL_FRAMEBUFFER_EXT, context ? context->getDefaultFboId() : 0);
    extensions.glUseProgram(0);
    _state.setLastAppliedProgramObject(nullptr);
    _state.setActiveTextureUnit(0);
    glPopClientAttrib();
    glPopAttrib();
    // OSG remembers what it applied, and must not take it for what is there.
    _state.haveAppliedAttribute(osg::StateAttribute::PROGRAM);
    _state.haveAppliedTextureAttribute(0, osg::StateAttribute::TEXTURE);
}

std::string linkProgram(osg::Program& program, osg::State& state)
{
    program.compileGLObjects(state);
    const osg::Program::PerContextProgram* linked = program.getPCP(state);
    return linked && linked->isLinked() ? std::string() : "the shaders of '" + program.getName() + "' do not compile";
}

int getGlInteger(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

} // namespace osgLego
