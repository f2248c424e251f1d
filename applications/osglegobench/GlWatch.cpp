#define GL_GLEXT_PROTOTYPES
#include "GlWatch.h"

#include <stdexcept>
#include <string>

#include <dlfcn.h>

namespace
{

std::size_t numWaits = 0;
osgLego::GlLedger* activeLedger = nullptr;

/** The renderer's own function, which one of this file stands before. */
template <typename Function>
Function* findNext(const char* name)
{
    void* const address = dlsym(RTLD_NEXT, name);
    if (!address) throw std::runtime_error(std::string("this machine's OpenGL has no ") + name);
    return reinterpret_cast<Function*>(address);
}

void noteTexture(GLenum target)
{
    if (activeLedger) activeLedger->noteTexture(target);
}

} // namespace

// What waits.

void glFinish()
{
    static const auto next = findNext<decltype(glFinish)>("glFinish");
    ++numWaits;
    next();
}

void glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels)
{
    static const auto next = findNext<decltype(glReadPixels)>("glReadPixels");
    ++numWaits;
    next(x, y, width, height, format, type, pixels);
}

void glGetTexImage(GLenum target, GLint level, GLenum format, GLenum type, void* pixels)
{
    static const auto next = findNext<decltype(glGetTexImage)>("glGetTexImage");
    ++numWaits;
    next(target, level, format, type, pixels);
}

void glGetQueryObjectiv(GLuint name, GLenum what, GLint* value)
{
    static const auto next = findNext<decltype(glGetQueryObjectiv)>("glGetQueryObjectiv");
    if (what == GL_QUERY_RESULT) ++numWaits;
    next(name, what, value);
}

void glGetQueryObjectuiv(GLuint name, GLenum what, GLuint* value)
{
    static const auto next = findNext<decltype(glGetQueryObjectuiv)>("glGetQueryObjectuiv");
    if (what == GL_QUERY_RESULT) ++numWaits;
    next(name, what, value);
}

void glGetQueryObjecti64v(GLuint name, GLenum what, GLint64* value)
{
    static const auto next = findNext<decltype(glGetQueryObjecti64v)>("glGetQueryObjecti64v");
    if (what == GL_QUERY_RESULT) ++numWaits;
    next(name, what, value);
}

void glGetQueryObjectui64v(GLuint name, GLenum what, GLuint64* value)
{
    static const auto next = findNext<decltype(glGetQueryObjectui64v)>("glGetQueryObjectui64v");
    if (what == GL_QUERY_RESULT) ++numWaits;
    next(name, what, value);
}

GLenum glClientWaitSync(GLsync sync, GLbitfield flags, GLuint64 timeout)
{
    static const auto next = findNext<decltype(glClientWaitSync)>("glClientWaitSync");
    ++numWaits;
    return next(sync, flags, timeout);
}

void glGetBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, void* data)
{
    static const auto next = findNext<decltype(glGetBufferSubData)>("glGetBufferSubData");
    ++numWaits;
    next(target, offset, size, data);
}

void* glMapBuffer(GLenum target, GLenum access)
{
    static const auto next = findNext<decltype(glMapBuffer)>("glMapBuffer");
    ++numWaits;
    return next(target, access);
}

void* glMapBufferRange(GLenum target, GLintptr offset, GLsizeiptr size, GLbitfield access)
{
    static const auto next = findNext<decltype(glMapBufferRange)>("glMapBufferRange");
    ++numWaits;
    return next(target, offset, size, access);
}

// What takes memory.

void glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
    static const auto next = findNext<decltype(glBufferData)>("glBufferData");
    next(target, size, data, usage);
    if (activeLedger) activeLedger->noteBuffer(target, static_cast<std::size_t>(size));
}

void glBufferStorage(GLenum target, GLsizeiptr size, const void* data, GLbitfield flags)
{
    static const auto next = findNext<decltype(glBufferStorage)>("glBufferStorage");
    next(target, size, data, flags);
    if (activeLedger) activeLedger->noteBuffer(target, static_cast<std::size_t>(size));
}

void glTexImage1D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLint border, GLenum format,
                  GLenum type, const void* pixels)
{
    static const auto next = findNext<decltype(glTexImage1D)>("glTexImage1D");
    next(target, level, internalFormat, width, border, format, type, pixels);
    noteTexture(target);
}

void glTexImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height, GLint border,
                  GLenum format, GLenum type, const void* pixels)
{
    static const auto next = findNext<decltype(glTexImage2D)>("glTexImage2D");
    next(target, level, internalFormat, width, height, border, format, type, pixels);
    noteTexture(target);
}

void glTexImage3D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height, GLsizei depth,
                  GLint border, GLenum format, GLenum type, const void* pixels)
{
    static const auto next = findNext<decltype(glTexImage3D)>("glTexImage3D");
    next(target, level, internalFormat, width, height, depth, border, format, type, pixels);
    noteTexture(target);
}

void glTexImage2DMultisample(GLenum target, GLsizei samples, GLenum internalFormat, GLsizei width, GLsizei height,
                             GLboolean fixedLocations)
{
    static const auto next = findNext<decltype(glTexImage2DMultisample)>("glTexImage2DMultisample");
    next(target, samples, internalFormat, width, height, fixedLocations);
    noteTexture(target);
}

void glTexImage3DMultisample(GLenum target, GLsizei samples, GLenum internalFormat, GLsizei width, GLsizei height,
                             GLsizei depth, GLboolean fixedLocations)
{
    static const auto next = findNext<decltype(glTexImage3DMultisample)>("glTexImage3DMultisample");
    next(target, samples, internalFormat, width, height, depth, fixedLocations);
    noteTexture(target);
}

void glTexStorage2D(GLenum target, GLsizei levels, GLenum internalFormat, GLsizei width, GLsizei height)
{
    static const auto next = findNext<decltype(glTexStorage2D)>("glTexStorage2D");
    next(target, levels, internalFormat, width, height);
    noteTexture(target);
}

void glTexStorage3D(GLenum target, GLsizei levels, GLenum internalFormat, GLsizei width, GLsizei height, GLsizei depth)
{
    static const auto next = findNext<decltype(glTexStorage3D)>("glTexStorage3D");
    next(target, levels, internalFormat, width, height, depth);
    noteTexture(target);
}

void glTexStorage2DMultisample(GLenum target, GLsizei samples, GLenum internalFormat, GLsizei width, GLsizei height,
                               GLboolean fixedLocations)
{
    static const auto next = findNext<decltype(glTexStorage2DMultisample)>("glTexStorage2DMultisample");
    next(target, samples, internalFormat, width, height, fixedLocations);
    noteTexture(target);
}

void glCopyTexImage2D(GLenum target, GLint level, GLenum internalFormat, GLint x, GLint y, GLsizei width,
                      GLsizei height, GLint border)
{
    static const auto next = findNext<decltype(glCopyTexImage2D)>("glCopyTexImage2D");
    next(target, level, internalFormat, x, y, width, height, border);
    noteTexture(target);
}

void glGenerateMipmap(GLenum target)
{
    static const auto next = findNext<decltype(glGenerateMipmap)>("glGenerateMipmap");
    next(target);
    noteTexture(target);
}

void glRenderbufferStorage(GLenum target, GLenum internalFormat, GLsizei width, GLsizei height)
{
    static const auto next = findNext<decltype(glRenderbufferStorage)>("glRenderbufferStorage");
    next(target, internalFormat, width, height);
    if (activeLedger) activeLedger->noteRenderBuffer();
}

void glRenderbufferStorageMultisample(GLenum target, GLsizei samples, GLenum internalFormat, GLsizei width,
                                      GLsizei height)
{
    static const auto next = findNext<decltype(glRenderbufferStorageMultisample)>("glRenderbufferStorageMultisample");
    next(target, samples, internalFormat, width, height);
    if (activeLedger) activeLedger->noteRenderBuffer();
}

// What gives it back.

void glDeleteBuffers(GLsizei number, const GLuint* names)
{
    static const auto next = findNext<decltype(glDeleteBuffers)>("glDeleteBuffers");
    next(number, names);
    if (activeLedger) activeLedger->forget(osgLego::GlLedger::Kind::BUFFER, number, names);
}

void glDeleteTextures(GLsizei number, const GLuint* names)
{
    static const auto next = findNext<decltype(glDeleteTextures)>("glDeleteTextures");
    next(number, names);
    if (activeLedger) activeLedger->forget(osgLego::GlLedger::Kind::TEXTURE, number, names);
}

void glDeleteRenderbuffers(GLsizei number, const GLuint* names)
{
    static const auto next = findNext<decltype(glDeleteRenderbuffers)>("glDeleteRenderbuffers");
    next(number, names);
    if (activeLedger) activeLedger->forget(osgLego::GlLedger::Kind::RENDER_BUFFER, number, names);
}

namespace osgLego
{

std::size_t GlWatch::countWaits()
{
    return numWaits;
}

void GlWatch::setLedger(GlLedger* ledger)
{
    activeLedger = ledger;
}

} // namespace osgLego
