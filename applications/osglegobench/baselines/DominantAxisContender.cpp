#include "DominantAxisContender.h"

#include "GatheredCells.h"

#include <osgLego/gl/GlMemory.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>

#include <algorithm>

#include <osg/GLExtensions>
#include <osg/Shader>

namespace osgLego
{

namespace
{

constexpr int VOLUME_UNIT = 0; // of image units
constexpr unsigned int GROUP_SIZE = 256;
constexpr GLuint COUNTERS = 0;
constexpr GLuint CELLS = 1;
constexpr GLuint POINTS = 2;

int longestSideOf(const BrickGrid& grid)
{
    return std::max({grid.dimensions.x, grid.dimensions.y, grid.dimensions.z});
}

template <typename Value>
void readBuffer(const osg::State& state, const GlBuffer& buffer, std::vector<Value>& values)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.get());
    extensions.glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(values.size() * sizeof(Value)),
                                  values.data());
    extensions.glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

} // namespace

std::string DominantAxisContender::createObjects(osg::State& state)
{
    constexpr float NEEDED_VERSION = 4.4f;
    if (state.get<osg::GLExtensions>()->glVersion < NEEDED_VERSION) return "it needs OpenGL 4.4";
    if (!osg::setGLExtensionFuncPtr(_clearTexture, "glClearTexImage")) return "GL lacks glClearTexImage";
    if (std::string error = createPrograms(state); !error.empty()) return error;
    if (std::string error = createVolume(state); !error.empty()) return error;
    _framebuffer = GlFramebuffer(state);
    _counters = GlBuffer(state);
    reserve(state, getTriangles().estimateCoveredCells());
    _numCells = 0;
    return {};
}

std::string DominantAxisContender::createPrograms(osg::State& state)
{
    _drawing =
        ShaderLibrary::getProgram("dominant axis", {"dominant_axis.vert", "dominant_axis.geom", "dominant_axis.frag"},
                                  _coverage == Coverage::CONSERVATIVE ? "#define IS_CONSERVATIVE\n" : "");
    _extraction = new osg::Program;
    _extraction->setName("osgLego::dominant axis extraction");
    _extraction->addShader(new osg::Shader(
        osg::Shader::COMPUTE, "#version 430\n" + ShaderLibrary::getSource("dominant_axis_extraction.comp")));
    std::string error = linkProgram(*_drawing, state);
    return error.empty() ? linkProgram(*_extraction, state) : error;
}

std::string DominantAxisContender::createVolume(osg::State& state)
{
    const glm::ivec3& dimensions = getGrid().dimensions;
    if (std::string error = checkTextureSide(longestSideOf(getGrid()), GL_MAX_3D_TEXTURE_SIZE); !error.empty())
        return error;
    takeOutOfMemoryError();
    _volume = GlTexture(state);
    glBindTexture(GL_TEXTURE_3D, _volume.get());
    state.get<osg::GLExtensions>()->glTexStorage3D(GL_TEXTURE_3D, 1, GL_R32UI, dimensions.x, dimensions.y,
                                                   dimensions.z);
    glBindTexture(GL_TEXTURE_3D, 0);
    return takeOutOfMemoryError() ? "there is not enough memory for a 3D texture of the grid's size" : "";
}

void DominantAxisContender::reserve(const osg::State& state, std::size_t numCells)
{
    _capacity = std::max(numCells, std::size_t(1)); // GL can't bind an empty buffer
    _cells = GlBuffer(state);
    uploadBuffer(state, GL_SHADER_STORAGE_BUFFER, _cells, std::vector<std::uint32_t>(_capacity), GL_DYNAMIC_COPY);
    _points = GlBuffer(state);
    uploadBuffer(state, GL_SHADER_STORAGE_BUFFER, _points, std::vector<BrickPoint>(_capacity), GL_DYNAMIC_COPY);
}

void DominantAxisContender::findBricks(osg::State& state)
{
    drawCells(state);
    _numCells = readCounters(state)[0];
    // The estimate was too small; the next run has enough capacity.
    if (_numCells > _capacity)
    {
        reserve(state, _numCells);
        drawCells(state);
    }
    extract(state, _numCells, false);
    // A renderer needs the number of points.
    readCounters(state);
}

void DominantAxisContender::bind(const osg::State& state) const
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glBindImageTexture(VOLUME_UNIT, _volume.get(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_R32UI);
    extensions.glBindBufferBase(GL_SHADER_STORAGE_BUFFER, COUNTERS, _counters.get());
    extensions.glBindBufferBase(GL_SHADER_STORAGE_BUFFER, CELLS, _cells.get());
    extensions.glBindBufferBase(GL_SHADER_STORAGE_BUFFER, POINTS, _points.get());
}

void DominantAxisContender::unbind(const osg::State& state) const
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    extensions.glMemoryBarrier(GL_ALL_BARRIER_BITS);
    extensions.glBindImageTexture(VOLUME_UNIT, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32UI);
    for (const GLuint index : {COUNTERS, CELLS, POINTS})
        extensions.glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, 0);
}

void DominantAxisContender::setCounters(const osg::State& state, const Counters& counters) const
{
    uploadBuffer(state, GL_SHADER_STORAGE_BUFFER, _counters, counters, GL_DYNAMIC_COPY);
}

DominantAxisContender::Counters DominantAxisContender::readCounters(const osg::State& state) const
{
    Counters counters(2);
    readBuffer(state, _counters, counters);
    return counters;
}

void DominantAxisContender::drawCells(osg::State& state) const
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    const int size = longestSideOf(getGrid());
    _clearTexture(_volume.get(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    setCounters(state, {0, 0});
    // A frame buffer without attachments, large enough for pictures along any axis.
    extensions.glBindFramebuffer(GL_FRAMEBUFFER_EXT, _framebuffer.get());
    extensions.glFramebufferParameteri(GL_FRAMEBUFFER_EXT, GL_FRAMEBUFFER_DEFAULT_WIDTH, size);
    extensions.glFramebufferParameteri(GL_FRAMEBUFFER_EXT, GL_FRAMEBUFFER_DEFAULT_HEIGHT, size);
    glViewport(0, 0, size, size);
    _drawing->apply(state);
    const ProgramUniforms uniforms(state);
    uniforms.set("pictureSize", static_cast<float>(size));
    uniforms.set("gridSize", getGrid().dimensions);
    bind(state);
    draw(state);
    unbind(state);
}

void DominantAxisContender::extract(osg::State& state, std::uint32_t numCells, bool takesHidden) const
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    setCounters(state, {numCells, 0});
    _extraction->apply(state);
    const ProgramUniforms uniforms(state);
    uniforms.set("gridSize", getGrid().dimensions);
    uniforms.set("takesHidden", takesHidden ? 1 : 0);
    bind(state);
    extensions.glDispatchCompute((numCells + GROUP_SIZE - 1) / GROUP_SIZE, 1, 1);
    unbind(state);
}

osg::ref_ptr<const BrickModel> DominantAxisContender::readBricks(osg::State& state)
{
    extract(state, _numCells, true);
    std::vector<BrickPoint> points(readCounters(state)[1]);
    readBuffer(state, _points, points);
    return createModel(getGrid(), points);
}

void DominantAxisContender::releaseObjects()
{
    _volume = GlTexture();
    _framebuffer = GlFramebuffer();
    _counters = GlBuffer();
    _cells = GlBuffer();
    _points = GlBuffer();
    _drawing = nullptr;
    _extraction = nullptr;
}

} // namespace osgLego
