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

/** Gives raw GL calls a plain state (every test and blending off, all masks open, pixels packed byte by byte) and
 * restores the context's state when it is destroyed. Needs the context current. */
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

/** Compile and link. @return why that can't be done, in one sentence; empty when it is done. */
std::string linkProgram(osg::Program& program, osg::State& state);

/** The value of an integer state of GL. */
int getGlInteger(GLenum name);

/** @param limit GL_MAX_TEXTURE_SIZE or the like.
 * @return why there can be no texture with a side of so many cells, in one sentence; empty when there can. */
std::string checkTextureSide(int numCells, GLenum limit);

/** A two-dimensional texture without content that is not filtered. */
GlTexture createGlTexture2D(const osg::State& state, GLenum internalFormat, GLenum format, GLenum type,
                            const glm::ivec2& size);

/** Replace the content of a buffer by a vector's. */
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
