#pragma once

#include <osgLego/gl/GlObject.h>

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <osg/Program>
#include <osg/State>

namespace osgLego
{

inline void createGlFramebuffer(const osg::GLExtensions& extensions, GLuint& name)
{
    extensions.glGenFramebuffers(1, &name);
}
inline void deleteGlFramebuffer(const osg::GLExtensions& extensions, GLuint name)
{
    extensions.glDeleteFramebuffers(1, &name);
}
inline void createGlQuery(const osg::GLExtensions& extensions, GLuint& name)
{
    extensions.glGenQueries(1, &name);
}
inline void deleteGlQuery(const osg::GLExtensions& extensions, GLuint name)
{
    extensions.glDeleteQueries(1, &name);
}

using GlFramebuffer = GlObject<createGlFramebuffer, deleteGlFramebuffer>;
using GlQuery = GlObject<createGlQuery, deleteGlQuery>;

/** Sets a plain state for raw GL calls (all tests and blending off, all masks enabled, pixels packed byte by byte), and
 * restores the context's state on destruction. Needs the context current. */
class GlRestoration
{
public:
    explicit GlRestoration(osg::State& state);
    ~GlRestoration();
    GlRestoration(const GlRestoration&) = delete;
    GlRestoration& operator=(const GlRestoration&) = delete;

private:
    osg::State& _state;
};

/** Compile and link a program. @return an error message, in one sentence; empty on success. */
std::string linkProgram(osg::Program& program, osg::State& state);

/** The value of an integer GL state. */
int getGlInteger(GLenum name);

/** @param limit GL_MAX_TEXTURE_SIZE or the like.
 * @return an error message, in one sentence, if a texture can't have a side of this many cells; otherwise empty. */
std::string checkTextureSide(int numCells, GLenum limit);

/** Create a two-dimensional texture without content and without filtering. */
GlTexture createGlTexture2D(const osg::State& state, GLenum internalFormat, GLenum format, GLenum type,
                            const glm::ivec2& size);

/** Replace the content of a buffer with that of a vector. */
template <typename Value>
void uploadBuffer(const osg::State& state, GLenum target, const GlBuffer& buffer, const std::vector<Value>& values,
                  GLenum usage)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindBuffer(target, buffer.get());
    extensions.glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), usage);
    extensions.glBindBuffer(target, 0);
}

} // namespace osgLego
