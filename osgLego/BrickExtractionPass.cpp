#include <osgLego/BrickExtractionPass.h>

#include <osgLego/GlMemory.h>
#include <osgLego/ProgramUniforms.h>
#include <osgLego/ShaderLibrary.h>
#include <osgLego/TransformFeedback.h>

#include <algorithm>
#include <cstdint>

namespace osgLego
{

namespace
{

constexpr int RUN_LENGTH = 16;
constexpr std::size_t BRICK_BYTES = 3 * sizeof(std::uint32_t);

osg::ref_ptr<osg::Program> createProgram()
{
    osg::ref_ptr<osg::Program> program =
        ShaderLibrary::createProgram("extraction", {"extraction.vert", "extraction.geom"},
                                     "#define RUN_LENGTH " + std::to_string(RUN_LENGTH) + "\n");
    program->addTransformFeedBackVarying("brick");
    program->setTransformFeedBackMode(GL_INTERLEAVED_ATTRIBS);
    return program;
}

/** Make room for `capacity` bricks; those that are there already stay. */
void reserve(const osg::State& state, Legolization& work, std::size_t capacity)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    std::vector<std::uint32_t> kept(3 * work.numBricks);
    const auto keptBytes = static_cast<GLsizeiptr>(work.numBricks * BRICK_BYTES);
    if (work.numBricks > 0)
    {
        extensions.glBindBuffer(GL_ARRAY_BUFFER, work.bricks.get());
        extensions.glGetBufferSubData(GL_ARRAY_BUFFER, 0, keptBytes, kept.data());
    }
    work.bricks = GlBuffer(state);
    work.brickCapacity = capacity;
    extensions.glBindBuffer(GL_ARRAY_BUFFER, work.bricks.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity * BRICK_BYTES), nullptr, GL_STATIC_DRAW);
    if (work.numBricks > 0) extensions.glBufferSubData(GL_ARRAY_BUFFER, 0, keptBytes, kept.data());
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

} // namespace

BrickExtractionPass::BrickExtractionPass(BrickStore& store, unsigned int step, const PassPlan& plan, std::size_t slab,
                                         osg::Texture2D& voxelImage) :
    LegolizationPass(store, step),
    _plan(plan), _slab(slab)
{
    constexpr osg::StateAttribute::OverrideValue OURS = osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;
    osg::ref_ptr<osg::StateSet> stateSet = PassCamera::createStateSet(*createProgram());
    stateSet->setTextureAttribute(0, &voxelImage, OURS);
    setStateSet(stateSet);
    setCamera(new PassCamera(*this));
}

std::string BrickExtractionPass::run(osg::State& state, ContextBricks& bricks) const
{
    Legolization& work = *bricks.work;
    const BrickGrid& grid = work.source->triangles->getGrid();
    const Slab slab = SlabPlan::create(grid).slabs[_slab];
    const ProgramUniforms uniforms(state);
    setAddressing(uniforms, grid, slab, _plan.imageSize);
    uniforms.set("firstLayer", slab.begin);

    // A capture needs a range that is not empty.
    constexpr std::size_t SPARE_BRICKS = 1024;
    if (work.brickCapacity == 0) reserve(state, work, work.source->triangles->estimateCoveredCells() + SPARE_BRICKS);
    if (work.brickCapacity == work.numBricks) reserve(state, work, 2 * work.brickCapacity);
    const int runs = (grid.dimensions.x + RUN_LENGTH - 1) / RUN_LENGTH;
    const int numRuns = runs * grid.dimensions.y * (slab.end - slab.begin);
    TransformFeedback feedback(*state.get<osg::GLExtensions>());
    while (true)
    {
        const auto offset = static_cast<GLintptr>(work.numBricks * BRICK_BYTES);
        const auto size = static_cast<GLsizeiptr>(work.brickCapacity * BRICK_BYTES) - offset;
        feedback.begin(GL_POINTS, work.bricks.get(), offset, size);
        glDrawArrays(GL_POINTS, 0, numRuns);
        feedback.end();
        const CapturedPrimitives result = feedback.getResult();
        if (result.isComplete())
        {
            work.numBricks += result.written;
            break;
        }
        const std::size_t needed = work.numBricks + result.generated;
        reserve(state, work, needed + needed / 8 + SPARE_BRICKS);
        if (takeOutOfMemoryError())
            return "there is no room for " + std::to_string(needed) + " bricks; allowed: a lower resolution";
    }

    if (_slab + 1 == _plan.numSlabs) bricks.finish();
    return {};
}

} // namespace osgLego
