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
    // OSG caches the state that it applied last, which is no longer GL's state.
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

std::string checkTextureSide(int numCells, GLenum limit)
{
    if (numCells <= getGlInteger(limit)) return {};
    return "a side of " + std::to_string(numCells) + " cells is beyond the " + std::to_string(getGlInteger(limit)) +
           " texels of a texture";
}

GlTexture createGlTexture2D(const osg::State& state, GLenum internalFormat, GLenum format, GLenum type,
                            const glm::ivec2& size)
{
    GlTexture texture(state);
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), size.x, size.y, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

} // namespace osgLego
