#include "GlFaults.h"

#include <atomic>

#include <dlfcn.h>
#include <osg/GLExtensions>

namespace
{

using osgLego::test::GlFaults;

constexpr int NONE = -1;

std::atomic<int> wantedKind{NONE};
std::atomic<std::size_t> numLeft{0}; // calls before the one that fails
std::atomic<bool> failAll{false};
std::atomic<std::size_t> numFailed{0};
std::atomic<bool> isOutOfMemory{false}; // until the next glGetError()

/** Whether a call of a kind is one that fails. */
bool mustFail(GlFaults::Kind kind)
{
    if (wantedKind != static_cast<int>(kind) || (numFailed > 0 && !failAll)) return false;
    if (numLeft > 0)
    {
        --numLeft;
        return false;
    }
    ++numFailed;
    return true;
}

/** The functions of a context that the functions below replace. */
struct Functions
{
    void(GL_APIENTRY* shaderSource)(GLuint, GLsizei, const GLchar**, const GLint*) = nullptr;
    void(GL_APIENTRY* getProgram)(GLuint, GLenum, GLint*) = nullptr;
    GLenum(GL_APIENTRY* checkFramebuffer)(GLenum) = nullptr;
    void(GL_APIENTRY* bufferData)(GLenum, GLsizeiptr, const GLvoid*, GLenum) = nullptr;
    GLvoid*(GL_APIENTRY* mapBufferRange)(GLenum, GLintptr, GLsizeiptr, GLbitfield) = nullptr;
    void(GL_APIENTRY* getQuery)(GLuint, GLenum, GLuint*) = nullptr;
} functions;

void GL_APIENTRY shaderSource(GLuint shader, GLsizei count, const GLchar** strings, const GLint* lengths)
{
    static const GLchar* invalid = "#error This shader fails.";
    if (mustFail(GlFaults::Kind::SHADER))
        functions.shaderSource(shader, 1, &invalid, nullptr);
    else
        functions.shaderSource(shader, count, strings, lengths);
}

void GL_APIENTRY getProgram(GLuint program, GLenum name, GLint* value)
{
    functions.getProgram(program, name, value);
    if (name == GL_LINK_STATUS && mustFail(GlFaults::Kind::PROGRAM)) *value = GL_FALSE;
}

GLenum GL_APIENTRY checkFramebuffer(GLenum target)
{
    return mustFail(GlFaults::Kind::FRAMEBUFFER) ? GL_FRAMEBUFFER_UNSUPPORTED_EXT : functions.checkFramebuffer(target);
}

void GL_APIENTRY bufferData(GLenum target, GLsizeiptr size, const GLvoid* data, GLenum usage)
{
    if (mustFail(GlFaults::Kind::BUFFER))
        isOutOfMemory = true;
    else
        functions.bufferData(target, size, data, usage);
}

GLvoid* GL_APIENTRY mapBufferRange(GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access)
{
    return mustFail(GlFaults::Kind::MAPPING) ? nullptr : functions.mapBufferRange(target, offset, length, access);
}

void GL_APIENTRY getQuery(GLuint query, GLenum name, GLuint* value)
{
    functions.getQuery(query, name, value);
    if (name == GL_QUERY_RESULT && mustFail(GlFaults::Kind::QUERY)) *value = 0;
}

template <typename Function>
void replace(Function& function, Function& kept, Function replacement)
{
    if (function == replacement) return;
    kept = function;
    function = replacement;
}

} // namespace

// This function replaces that of GL's library in the whole program.
extern "C"
{
    GLAPI GLenum GLAPIENTRY glGetError()
    {
        static const auto next = reinterpret_cast<GLenum(GLAPIENTRY*)()>(dlsym(RTLD_NEXT, "glGetError"));
        return isOutOfMemory.exchange(false) ? GL_OUT_OF_MEMORY : next();
    }
}

namespace osgLego::test
{

void GlFaults::begin(osg::GraphicsContext& context, Kind kind, std::size_t call)
{
    osg::GLExtensions& extensions = *context.getState()->get<osg::GLExtensions>();
    replace(extensions.glShaderSource, functions.shaderSource, &shaderSource);
    replace(extensions.glGetProgramiv, functions.getProgram, &getProgram);
    replace(extensions.glCheckFramebufferStatus, functions.checkFramebuffer, &checkFramebuffer);
    replace(extensions.glBufferData, functions.bufferData, &bufferData);
    replace(extensions.glMapBufferRange, functions.mapBufferRange, &mapBufferRange);
    replace(extensions.glGetQueryObjectuiv, functions.getQuery, &getQuery);
    failAll = false;
    numFailed = 0;
    isOutOfMemory = false;
    numLeft = call;
    wantedKind = static_cast<int>(kind);
}

void GlFaults::beginAll(osg::GraphicsContext& context, Kind kind)
{
    begin(context, kind, 0);
    failAll = true;
}

std::size_t GlFaults::getNumFailed()
{
    return numFailed;
}

bool GlFaults::end()
{
    wantedKind = NONE;
    return numFailed > 0;
}

} // namespace osgLego::test
