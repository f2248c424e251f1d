#include <osgLego/polygonization/DepthPass.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <osg/Camera>
#include <osg/GLExtensions>
#include <osgUtil/RenderStage>

namespace osgLego
{

namespace
{

constexpr unsigned int NUM_DRAW_BUFFERS = 8; // GL's minimum of GL_MAX_DRAW_BUFFERS

/** Whether a camera with a frame buffer object attaches no colours. OSG adds a colour buffer, which nobody reads. */
bool hasDepthsOnly(const osg::Camera& camera)
{
    GLint frameBuffer = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frameBuffer);
    const osg::Camera::BufferAttachmentMap& attachments = camera.getBufferAttachmentMap();
    // Those for colours come after those for depths and stencil values.
    return frameBuffer != 0 && camera.getRenderTargetImplementation() == osg::Camera::FRAME_BUFFER_OBJECT &&
           !attachments.empty() && attachments.rbegin()->first < osg::Camera::COLOR_BUFFER;
}

/** Whether the draw buffers and the color mask let no colours pass. */
bool masksColors()
{
    // The color mask is that of the first buffer; others may have their own.
    for (unsigned int number = 1; number < NUM_DRAW_BUFFERS; ++number)
    {
        GLint buffer = GL_NONE;
        glGetIntegerv(GL_DRAW_BUFFER0 + number, &buffer);
        if (buffer != GL_NONE) return false;
    }
    GLint buffer = GL_NONE;
    glGetIntegerv(GL_DRAW_BUFFER0, &buffer);
    if (buffer == GL_NONE) return true;
    std::array<GLboolean, 4> mask{};
    glGetBooleanv(GL_COLOR_WRITEMASK, mask.data());
    return std::none_of(mask.begin(), mask.end(), [](GLboolean isWritten) { return isWritten == GL_TRUE; });
}

/** The number of bits that resolve the depths in the current frame buffer. */
int findDepthBits()
{
    constexpr GLint SIGNIFICAND = 24; // of depths in single precision
    GLint frameBuffer = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &frameBuffer);
    GLint bits = SIGNIFICAND;
    // osg::GLExtensions does not have this function, which all drivers with frame buffer objects do.
    using Function = void GL_APIENTRY(GLenum target, GLenum attachment, GLenum name, GLint * value);
    static auto* const getParameter =
        reinterpret_cast<Function*>(osg::getGLExtensionFuncPtr("glGetFramebufferAttachmentParameteriv"));
    if (getParameter)
        getParameter(GL_DRAW_FRAMEBUFFER, frameBuffer != 0 ? GL_DEPTH_ATTACHMENT_EXT : GL_DEPTH,
                     GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits);
    return std::min(bits, SIGNIFICAND);
}

} // namespace

bool isDepthPass(osg::RenderInfo& renderInfo)
{
    const osg::RenderInfo::RenderBinStack& bins = renderInfo.getRenderBinStack();
    const osg::Camera* camera = bins.empty() ? nullptr : bins.back()->getStage()->getCamera();
    return (camera && hasDepthsOnly(*camera)) || masksColors();
}

DepthConversion::DepthConversion(const osg::State& state)
{
    std::array<GLfloat, 2> limits{};
    glGetFloatv(GL_DEPTH_RANGE, limits.data());
    range = {limits[0], limits[1]};
    if (!state.getLastAppliedMode(GL_POLYGON_OFFSET_FILL)) return;
    GLfloat factor = 0.0f;
    GLfloat units = 0.0f;
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &factor);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &units);
    offset = {factor, std::ldexp(units, -findDepthBits())};
}

} // namespace osgLego
