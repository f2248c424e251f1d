#pragma once

#include <osgLego/gl/GlObject.h>

#include <string>

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

/** Gives raw GL calls plain state to begin with (every test and every blending off, all masks open, pixels packed byte
 * by byte), and the context what it had before when it goes. Needs the context current. */
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

/** The value of an integer that GL answers. */
int getGlInteger(GLenum name);

} // namespace osgLego
