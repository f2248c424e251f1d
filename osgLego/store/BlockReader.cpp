#include <osgLego/store/BlockReader.h>

#include <osgLego/gl/GlMemory.h>

namespace osgLego
{

void BlockReader::start(const osg::State& state, GLuint buffer, GLsizei numBricks)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    stop();
    deleteFence(extensions);
    // In OpenGL 3.1, but missing from osg::GLExtensions.
    using CopyBuffer = void(GL_APIENTRY*)(GLenum, GLenum, GLintptr, GLintptr, GLsizeiptr);
    CopyBuffer copyBuffer = nullptr;
    if (numBricks == 0 || !osg::setGLExtensionFuncPtr(copyBuffer, "glCopyBufferSubData")) return;
    const auto size = static_cast<GLsizeiptr>(static_cast<std::size_t>(numBricks) * sizeof(BrickPoint));
    _copy = GlBuffer(state);
    _numBricks = numBricks;
    extensions.glBindBuffer(GL_COPY_WRITE_BUFFER, _copy.get());
    extensions.glBufferData(GL_COPY_WRITE_BUFFER, size, nullptr, GL_STREAM_READ);
    // Without memory for the copy, the bricks stay without blocks, and all of them are drawn.
    const bool hasMemory = !takeOutOfMemoryError();
    if (hasMemory)
    {
        extensions.glBindBuffer(GL_COPY_READ_BUFFER, buffer);
        copyBuffer(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, size);
        extensions.glBindBuffer(GL_COPY_READ_BUFFER, 0);
        _fence = extensions.glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    }
    extensions.glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    if (!hasMemory) stop();
}

void BlockReader::poll(const osg::State& state, bool waits, const std::function<void(std::span<const BrickPoint>)>& use)
{
    constexpr GLuint64 FOREVER = ~GLuint64(0);
    if (!_fence) return;
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    const GLenum result =
        extensions.glClientWaitSync(_fence, waits ? GL_SYNC_FLUSH_COMMANDS_BIT : 0, waits ? FOREVER : 0);
    if (result != GL_ALREADY_SIGNALED && result != GL_CONDITION_SATISFIED) return;
    deleteFence(extensions);
    if (_numBricks == 0) return; // the copy was dropped
    extensions.glBindBuffer(GL_COPY_READ_BUFFER, _copy.get());
    const auto size = static_cast<GLsizeiptr>(static_cast<std::size_t>(_numBricks) * sizeof(BrickPoint));
    if (const void* points = extensions.glMapBufferRange(GL_COPY_READ_BUFFER, 0, size, GL_MAP_READ_BIT))
    {
        use({static_cast<const BrickPoint*>(points), static_cast<std::size_t>(_numBricks)});
        extensions.glUnmapBuffer(GL_COPY_READ_BUFFER);
    }
    extensions.glBindBuffer(GL_COPY_READ_BUFFER, 0);
    stop();
}

void BlockReader::stop()
{
    _copy = GlBuffer();
    _numBricks = 0;
}

void BlockReader::forget()
{
    stop();
    _fence = nullptr;
}

void BlockReader::deleteFence(const osg::GLExtensions& extensions)
{
    if (_fence) extensions.glDeleteSync(_fence);
    _fence = nullptr;
}

} // namespace osgLego
