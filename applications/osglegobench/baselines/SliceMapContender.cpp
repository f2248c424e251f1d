#include "SliceMapContender.h"

#include "DepthPicture.h"

#include <osgLego/gl/ShaderLibrary.h>

#include <algorithm>
#include <bit>

#include <osg/GLExtensions>

namespace osgLego
{

namespace
{

constexpr int WORD_BITS = 32;
constexpr int WORDS_PER_TEXEL = 4;
constexpr int TARGET_BITS = WORD_BITS * WORDS_PER_TEXEL;
constexpr GLuint NOTHING[4] = {0, 0, 0, 0};
constexpr std::uint32_t GREY = 0xffa0a0a0;

GLenum attachmentOf(int target)
{
    return GL_COLOR_ATTACHMENT0_EXT + static_cast<GLenum>(target);
}

} // namespace

std::string SliceMapContender::createObjects(osg::State& state)
{
    const glm::ivec3& dimensions = getGrid().dimensions;
    if (std::string error = checkTextureSide(std::max(dimensions.x, dimensions.y), GL_MAX_TEXTURE_SIZE); !error.empty())
        return error;
    if (!osg::setGLExtensionFuncPtr(_clearBuffer, "glClearBufferuiv")) return "GL lacks glClearBufferuiv";
    _numTargets = std::min(getGlInteger(GL_MAX_DRAW_BUFFERS), (dimensions.z + TARGET_BITS - 1) / TARGET_BITS);
    _program = ShaderLibrary::getProgram("slice map", {"slice_map.vert", "slice_map.frag"},
                                         "#define NUM_TARGETS " + std::to_string(_numTargets) + "\n");
    if (std::string error = linkProgram(*_program, state); !error.empty()) return error;

    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    _framebuffer = GlFramebuffer(state);
    extensions.glBindFramebuffer(GL_FRAMEBUFFER_EXT, _framebuffer.get());
    std::vector<GLenum> attachments;
    _targets.clear();
    for (int target = 0; target < _numTargets; ++target)
    {
        _targets.push_back(
            createGlTexture2D(state, GL_RGBA32UI_EXT, GL_RGBA_INTEGER_EXT, GL_UNSIGNED_INT, glm::ivec2(dimensions)));
        extensions.glFramebufferTexture2D(GL_FRAMEBUFFER_EXT, attachmentOf(target), GL_TEXTURE_2D,
                                          _targets.back().get(), 0);
        attachments.push_back(attachmentOf(target));
    }
    extensions.glDrawBuffers(_numTargets, attachments.data());
    if (extensions.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) != GL_FRAMEBUFFER_COMPLETE_EXT)
        return "GL can't draw to " + std::to_string(_numTargets) + " textures of four 32-bit integers a texel";
    return ReadBackContender::createObjects(state);
}

void SliceMapContender::gatherCells(osg::State& state, GatheredCells& cells)
{
    const glm::ivec3& dimensions = getGrid().dimensions;
    _program->apply(state);
    const ProgramUniforms uniforms(state);
    uniforms.set("pictureSize", glm::vec2(dimensions));
    uniforms.set("depthRange", getDepthRange(dimensions.z));
    state.get<osg::GLExtensions>()->glBindFramebuffer(GL_FRAMEBUFFER_EXT, _framebuffer.get());
    glViewport(0, 0, dimensions.x, dimensions.y);
    glLogicOp(GL_OR);
    for (int firstLayer = 0; firstLayer < dimensions.z; firstLayer += _numTargets * TARGET_BITS)
    {
        glDisable(GL_COLOR_LOGIC_OP);
        for (int target = 0; target < _numTargets; ++target)
            _clearBuffer(GL_COLOR, target, NOTHING);
        glEnable(GL_COLOR_LOGIC_OP);
        uniforms.set("firstLayer", firstLayer);
        draw(state);
        for (int target = 0; target < _numTargets; ++target)
            readTarget(target, firstLayer + target * TARGET_BITS, cells);
    }
}

void SliceMapContender::readTarget(int target, int firstLayer, GatheredCells& cells)
{
    const glm::ivec3& dimensions = getGrid().dimensions;
    _readBits.resize(WORDS_PER_TEXEL * static_cast<std::size_t>(dimensions.x) * static_cast<std::size_t>(dimensions.y));
    glReadBuffer(attachmentOf(target));
    glReadPixels(0, 0, dimensions.x, dimensions.y, GL_RGBA_INTEGER_EXT, GL_UNSIGNED_INT, _readBits.data());

    auto word = _readBits.cbegin();
    for (int y = 0; y < dimensions.y; ++y)
        for (int x = 0; x < dimensions.x; ++x)
            for (int layer = firstLayer; layer < firstLayer + TARGET_BITS; layer += WORD_BITS, ++word)
                for (std::uint32_t bits = *word; bits != 0; bits &= bits - 1)
                    cells.add({x, y, layer + std::countr_zero(bits)}, GREY);
}

void SliceMapContender::releaseObjects()
{
    _framebuffer = GlFramebuffer();
    _targets.clear();
    _readBits = {};
    _program = nullptr;
    ReadBackContender::releaseObjects();
}

} // namespace osgLego
