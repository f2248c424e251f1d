#include "GlDebug.h"

#include <mutex>
#include <stdexcept>

#include <EGL/egl.h>
#include <osg/GLDefines>

namespace osgLego::test
{

namespace
{

constexpr GLenum DEBUG_OUTPUT = 0x92E0;             // GL_DEBUG_OUTPUT
constexpr GLenum DEBUG_OUTPUT_SYNCHRONOUS = 0x8242; // GL_DEBUG_OUTPUT_SYNCHRONOUS
constexpr GLenum DEBUG_TYPE_ERROR = 0x824C;         // GL_DEBUG_TYPE_ERROR
constexpr GLenum DEBUG_SEVERITY_HIGH = 0x9146;      // GL_DEBUG_SEVERITY_HIGH

using DebugCallback = void(GL_APIENTRY*)(GLenum, GLenum, GLuint, GLenum, GLsizei, const char*, const void*);
using DebugMessageCallback = void(GL_APIENTRY*)(DebugCallback, const void*);

std::mutex mutex;
std::vector<std::string> messages;

void GL_APIENTRY receive(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const char* text, const void*)
{
    if (type != DEBUG_TYPE_ERROR && severity != DEBUG_SEVERITY_HIGH) return;
    const std::lock_guard lock(mutex);
    messages.emplace_back(text);
}

} // namespace

void watchGl(osg::GraphicsContext& context)
{
    const auto setCallback = reinterpret_cast<DebugMessageCallback>(eglGetProcAddress("glDebugMessageCallback"));
    if (!context.makeCurrent() || !setCallback) throw std::runtime_error("GL has no debug output");
    glEnable(DEBUG_OUTPUT);
    glEnable(DEBUG_OUTPUT_SYNCHRONOUS);
    setCallback(receive, nullptr);
    context.releaseContext();
}

std::vector<std::string> takeGlMessages()
{
    const std::lock_guard lock(mutex);
    return std::exchange(messages, {});
}

} // namespace osgLego::test
