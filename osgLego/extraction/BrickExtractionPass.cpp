#include <osgLego/extraction/BrickExtractionPass.h>

#include <osgLego/data/BrickNeighbors.h>
#include <osgLego/data/BrickPoints.h>
#include <osgLego/gl/GlMemory.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/passes/Addressing.h>

#include <cstddef>
#include <cstdint>

namespace osgLego
{

namespace
{

constexpr GLsizei WORD_BYTES = sizeof(std::uint32_t);
constexpr GLsizei BLOCK_BYTES = Occupancy::WORDS_PER_BLOCK * WORD_BYTES;
constexpr std::size_t BRICK_BYTES = sizeof(BrickPoint);
constexpr const char* NO_SHADERS = "the shaders of BrickExtractionPass failed to compile";
// Unit 0 is the voxel image.
constexpr int OCCUPANCY_UNIT = 1;
constexpr unsigned int TABLE_UNIT = 2;
constexpr unsigned int COLORS_UNIT = 3;

/** Feeds integers, up to four per attribute, to a vertex shader during its lifetime, from location 0 on. */
class NumberArrays
{
public:
    NumberArrays(const osg::GLExtensions& extensions, GLuint buffer, GLsizei stride, GLint size, GLuint count) :
        _extensions(extensions), _count(count)
    {
        _extensions.glBindBuffer(GL_ARRAY_BUFFER, buffer);
        for (GLuint attribute = 0; attribute < count; ++attribute)
        {
            const std::size_t offset = attribute * static_cast<std::size_t>(size * WORD_BYTES);
            _extensions.glEnableVertexAttribArray(attribute);
            _extensions.glVertexAttribIPointer(attribute, size, GL_UNSIGNED_INT, stride,
                                               reinterpret_cast<const void*>(offset));
        }
        _extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
    ~NumberArrays()
    {
        for (GLuint attribute = 0; attribute < _count; ++attribute)
            _extensions.glDisableVertexAttribArray(attribute);
    }
    NumberArrays(const NumberArrays&) = delete;
    NumberArrays& operator=(const NumberArrays&) = delete;

private:
    const osg::GLExtensions& _extensions;
    GLuint _count;
};

/** Binds the occupancy to its texture unit during its lifetime. */
class OccupancyTexture
{
public:
    OccupancyTexture(osg::State& state, const Occupancy& occupancy) : _state(state) { bind(occupancy.getTexture()); }
    ~OccupancyTexture() { bind(0); }
    OccupancyTexture(const OccupancyTexture&) = delete;
    OccupancyTexture& operator=(const OccupancyTexture&) = delete;

private:
    void bind(GLuint texture) const
    {
        _state.setActiveTextureUnit(OCCUPANCY_UNIT);
        glBindTexture(GL_TEXTURE_BUFFER, texture);
    }

    osg::State& _state;
};

/** Allocate memory for `capacity` bricks, and keep those already captured. */
void reserve(const osg::State& state, Legolization& work, std::size_t capacity)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    std::vector<std::uint32_t> kept(3 * work.numBricks);
    const auto keptBytes = static_cast<GLsizeiptr>(work.numBricks * BRICK_BYTES);
    if (work.numBricks > 0)
    {
        extensions.glBindBuffer(GL_ARRAY_BUFFER, work.buffer.get());
        extensions.glGetBufferSubData(GL_ARRAY_BUFFER, 0, keptBytes, kept.data());
    }
    work.buffer.deleteNow(state);
    work.buffer = GlBuffer(state);
    work.brickCapacity = capacity;
    extensions.glBindBuffer(GL_ARRAY_BUFFER, work.buffer.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity * BRICK_BYTES), nullptr, GL_STATIC_DRAW);
    if (work.numBricks > 0) extensions.glBufferSubData(GL_ARRAY_BUFFER, 0, keptBytes, kept.data());
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

std::string describeLackOfRoom(std::size_t numBricks)
{
    return "there is not enough memory on the GPU for " + std::to_string(numBricks) +
           " bricks; expected a lower resolution";
}

/** Fill the occupancy from the voxel image. */
void findOccupancy(const osg::State& state, const Occupancy& occupancy, int numBlocks)
{
    TransformFeedback feedback(*state.get<osg::GLExtensions>());
    feedback.begin(GL_POINTS, occupancy.getBuffer(), 0, static_cast<GLsizeiptr>(numBlocks) * BLOCK_BYTES);
    glDrawArrays(GL_POINTS, 0, numBlocks * Occupancy::WORDS_PER_BLOCK);
    feedback.end();
}

/** Capture the numbers of the non-empty words of the occupancy. */
void findWords(const osg::State& state, const Occupancy& occupancy, int numBlocks, GLuint words,
               TransformFeedback& feedback)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    // Large enough for all words.
    const GLsizeiptr size = static_cast<GLsizeiptr>(numBlocks) * BLOCK_BYTES;
    extensions.glBindBuffer(GL_ARRAY_BUFFER, words);
    extensions.glBufferData(GL_ARRAY_BUFFER, size, nullptr, GL_DYNAMIC_COPY);
    const NumberArrays arrays(extensions, occupancy.getBuffer(), BLOCK_BYTES, 4, Occupancy::WORDS_PER_BLOCK / 4);
    feedback.begin(GL_POINTS, words, 0, size);
    glDrawArrays(GL_POINTS, 0, numBlocks);
    feedback.end();
}

} // namespace

BrickExtractionPass::BrickExtractionPass(PassWorkspace& workspace, unsigned int step, const PassPlan& plan,
                                         std::size_t slab, const ExtractionStates& states) :
    LegolizationPass(workspace, step),
    _plan(plan), _slab(slab), _states(&states)
{
    setStateSet(&states.getWords());
    setCamera(new PassCamera(*this));
}

std::string BrickExtractionPass::run(osg::State& state, Legolization& work) const
{
    const BrickGrid& grid = work.source->triangles->getGrid();
    const Slab slab = _plan.createSlabs(grid).slabs[_slab];
    const int numBlocks = Occupancy::countBlocks(grid, slab);
    if (!work.occupancy.isMarked())
    {
        if (!apply(state, _states->getOccupancy(), grid, slab)) return NO_SHADERS;
        findOccupancy(state, work.occupancy, numBlocks);
    }

    if (!apply(state, _states->getWords(), grid, slab)) return NO_SHADERS;
    GlBuffer wordBuffer(state);
    TransformFeedback words(*state.get<osg::GLExtensions>());
    findWords(state, work.occupancy, numBlocks, wordBuffer.get(), words);
    if (takeOutOfMemoryError())
        return "there is not enough memory on the GPU for the words of the occupancy; expected a lower resolution";

    if (!apply(state, _states->getBricks(), grid, slab)) return NO_SHADERS;
    const ProgramUniforms uniforms(state);
    uniforms.set("occupancy", OCCUPANCY_UNIT);
    uniforms.set("layers", glm::ivec2(slab.begin, slab.end));
    bindPaletteOf(state, *work.source, TABLE_UNIT, COLORS_UNIT);
    const OccupancyTexture texture(state, work.occupancy);
    {
        const NumberArrays arrays(*state.get<osg::GLExtensions>(), wordBuffer.get(), WORD_BYTES, 1, 1);
        if (std::string failure = capture(state, work, words); !failure.empty()) return failure;
    }
    wordBuffer.deleteNow(state); // else those of all slabs would exist until the end of the frame
    if (_slab + 1 < _plan.numSlabs) return {};
    if (_plan.numSlabs == 1 && getWorkspace().areNeighborsWanted())
        if (std::string failure = findNeighbors(state, work, slab); !failure.empty()) return failure;
    work.isComplete = true;
    return {};
}

/** Capture the neighbours of all bricks, with the occupancy bound. Without memory for them, none are captured.
 * @return the reason for a failure; empty on success. */
std::string BrickExtractionPass::findNeighbors(osg::State& state, Legolization& work, const Slab& slab) const
{
    if (work.numBricks == 0) return {};
    if (!apply(state, _states->getNeighbors(), work.source->triangles->getGrid(), slab)) return NO_SHADERS;
    ProgramUniforms(state).set("occupancy", OCCUPANCY_UNIT);
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    const auto size = static_cast<GLsizeiptr>(work.numBricks * sizeof(BrickNeighbors));
    work.neighbors = GlBuffer(state);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, work.neighbors.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, size, nullptr, GL_STATIC_DRAW);
    const NumberArrays arrays(extensions, work.buffer.get(), BRICK_BYTES, 3, 1);
    TransformFeedback feedback(extensions);
    feedback.begin(GL_POINTS, work.neighbors.get(), 0, size);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(work.numBricks));
    feedback.end();
    if (takeOutOfMemoryError()) work.neighbors.deleteNow(state);
    return {};
}

/** Apply a program and set its addressing. @return false if its shaders failed to compile. */
bool BrickExtractionPass::apply(osg::State& state, const osg::StateSet& stateSet, const BrickGrid& grid,
                                const Slab& slab) const
{
    state.apply(&stateSet);
    if (!state.getLastAppliedProgramObject()) return false;
    setAddressing(ProgramUniforms(state), grid, slab, _plan.imageSize);
    return true;
}

/** Capture the bricks of the captured words, with the program and its arrays already set up.
 * @return the reason for a failure; empty on success. */
std::string BrickExtractionPass::capture(osg::State& state, Legolization& work, const TransformFeedback& words) const
{
    // Transform feedback needs a non-empty range.
    constexpr std::size_t SPARE_BRICKS = 1024;
    if (work.brickCapacity == 0) reserve(state, work, work.source->triangles->estimateCoveredCells() + SPARE_BRICKS);
    if (work.brickCapacity == work.numBricks) reserve(state, work, 2 * work.brickCapacity);
    if (takeOutOfMemoryError()) return describeLackOfRoom(work.brickCapacity);
    TransformFeedback feedback(*state.get<osg::GLExtensions>());
    while (true)
    {
        const auto offset = static_cast<GLintptr>(work.numBricks * BRICK_BYTES);
        const auto size = static_cast<GLsizeiptr>(work.brickCapacity * BRICK_BYTES) - offset;
        feedback.begin(GL_POINTS, work.buffer.get(), offset, size);
        words.draw(GL_POINTS);
        feedback.end();
        const CapturedPrimitives result = feedback.getResult();
        if (result.isComplete())
        {
            work.numBricks += result.written;
            return {};
        }
        const std::size_t needed = work.numBricks + result.generated;
        reserve(state, work, needed + needed / 8 + SPARE_BRICKS);
        if (takeOutOfMemoryError()) return describeLackOfRoom(needed);
    }
}

void BrickExtractionPass::releaseGLObjects(osg::State* state) const
{
    LegolizationPass::releaseGLObjects(state);
    _states->releaseGLObjects(state);
}

void BrickExtractionPass::resizeGLObjectBuffers(unsigned int maxSize)
{
    LegolizationPass::resizeGLObjectBuffers(maxSize);
    _states->resizeGLObjectBuffers(maxSize);
}

} // namespace osgLego
