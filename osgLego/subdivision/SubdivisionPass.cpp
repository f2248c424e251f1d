#include <osgLego/subdivision/SubdivisionPass.h>

#include <osgLego/gl/GlMemory.h>
#include <osgLego/gl/GlRequirements.h>
#include <osgLego/gl/PassState.h>
#include <osgLego/gl/ProgramUniforms.h>
#include <osgLego/gl/ShaderLibrary.h>
#include <osgLego/gl/TransformFeedback.h>
#include <osgLego/passes/GridVertexArrays.h>
#include <osgLego/subdivision/GridCut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace osgLego
{

namespace
{

static_assert(6 * GridBatch::MAXIMUM_TRIANGLES <= GlRequirements::BUFFER_TEXELS);

// The size limit of a buffer of fine triangles; with larger buffers, drivers fail in different ways.
constexpr double MAXIMUM_BYTES = 3.0 * (1u << 30);
// Every pass halves edges that are too long; if one is still too long after this many passes, single precision can't
// halve its coordinates.
constexpr std::size_t MAXIMUM_PASSES = 64;

std::string outOfMemory(double bytes)
{
    std::ostringstream text;
    text << "there is not enough memory on the GPU for " << std::ceil(bytes / (1 << 20))
         << " MiB of subdivided triangles; expected a lower resolution or a larger edge limit";
    return text.str();
}

/** Subdivides one batch of triangles. Needs the program of the pass applied. */
class BatchSubdivision
{
public:
    /** @param coarse the triangles in the batch's coarse buffer. */
    BatchSubdivision(const osg::State& state, const GridBatch& coarse, WorkingBatch& batch, double edgeLimit,
                     bool hasColors) :
        _state(state),
        _extensions(*state.get<osg::GLExtensions>()), _coarse(coarse), _batch(batch), _edgeLimit(edgeLimit),
        _hasColors(hasColors)
    {
        if (!hasColors) _batch.fineVertexBytes = GridVertexArrays::BYTES_WITHOUT_COLORS;
    }

    /** @return the reason for a failure; empty on success. */
    std::string run()
    {
        const std::size_t estimate = _coarse.estimateFineTriangles(_edgeLimit);
        std::size_t capacity = estimate + estimate / 4 + 1024;
        while (true)
        {
            const double bytes = 3.0 * static_cast<double>(capacity) * _batch.fineVertexBytes;
            if (bytes > MAXIMUM_BYTES || !allocate(static_cast<GLsizeiptr>(bytes))) return outOfMemory(bytes);
            switch (subdivide())
            {
            case Outcome::FINE:
                _batch.fine = std::move(_buffers[_last]);
                _buffers[1 - _last].deleteNow(_state); // memory that voxelization needs in the same frame
                _batch.numFineTriangles = static_cast<GLsizei>(_count);
                return {};
            case Outcome::ENDLESS:
                return "subdivision does not end; expected coordinates that single precision can halve";
            case Outcome::TOO_SMALL:
                capacity = std::max<std::size_t>(2 * capacity, _count + _count / 4);
                break;
            }
        }
    }

    std::size_t getNumPasses() const { return _numPasses; }

private:
    enum class Outcome
    {
        FINE,
        TOO_SMALL,
        ENDLESS
    };

    bool allocate(GLsizeiptr bytes)
    {
        _bytes = bytes;
        for (GlBuffer& buffer : _buffers)
            buffer.deleteNow(_state);
        for (GlBuffer& buffer : _buffers)
        {
            buffer = GlBuffer(_state);
            _extensions.glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
            _extensions.glBufferData(GL_ARRAY_BUFFER, _bytes, nullptr, GL_DYNAMIC_COPY);
        }
        _extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
        return !takeOutOfMemoryError();
    }

    /** Algorithm 1: run passes as long as they change the number of triangles. */
    Outcome subdivide()
    {
        const double halvings = std::log2(static_cast<double>(_coarse.longestEdge) / _edgeLimit);
        std::size_t target = static_cast<std::size_t>(std::max(1.0, std::ceil(halvings))) + 1;
        _count = static_cast<GLuint>(_coarse.getNumTriangles());
        _numPasses = 0;
        std::vector<std::unique_ptr<TransformFeedback>> passes;
        while (target <= MAXIMUM_PASSES)
        {
            while (passes.size() < target)
            {
                passes.push_back(std::make_unique<TransformFeedback>(_extensions));
                draw(passes);
            }
            for (; _numPasses < passes.size(); ++_numPasses)
            {
                const CapturedPrimitives result = passes[_numPasses]->getResult();
                const bool unchanged = result.generated == _count;
                _count = result.generated;
                if (!result.isComplete()) return Outcome::TOO_SMALL;
                if (unchanged) return Outcome::FINE;
            }
            target += 2;
        }
        return Outcome::ENDLESS;
    }

    /** Capture the last pass from the output of the one before it, or from the source. */
    void draw(const std::vector<std::unique_ptr<TransformFeedback>>& passes)
    {
        const GridVertexArrays arrays(_extensions, _hasColors);
        const bool isFirst = passes.size() == 1;
        if (isFirst)
            arrays.bind(_batch.getCoarseBuffer());
        else
            arrays.bind(_buffers[_last].get(), _batch.fineVertexBytes);
        _last = isFirst ? 0 : 1 - _last;
        passes.back()->begin(GL_TRIANGLES, _buffers[_last].get(), 0, _bytes);
        if (isFirst)
            glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(_coarse.vertices.size()));
        else
            passes[passes.size() - 2]->draw(GL_TRIANGLES);
        passes.back()->end();
    }

    const osg::State& _state;
    const osg::GLExtensions& _extensions;
    const GridBatch& _coarse;
    WorkingBatch& _batch;
    double _edgeLimit;
    bool _hasColors;
    std::array<GlBuffer, 2> _buffers;
    GLsizeiptr _bytes = 0;
    std::size_t _last = 0; // the index of the last buffer captured into
    GLuint _count = 0;
    std::size_t _numPasses = 0;
};

GlBuffer createBuffer(const osg::State& state, const GridBatch& batch)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    GlBuffer buffer(state);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
    extensions.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(batch.vertices.size() * sizeof(GridVertex)),
                            batch.vertices.data(), GL_STATIC_DRAW);
    extensions.glBindBuffer(GL_ARRAY_BUFFER, 0);
    return buffer;
}

/** Upload the source's vertices into a buffer, and create a buffer texture from which shaders read its triangles. */
WorkingBatch upload(osg::State& state, const GridBatch& batch)
{
    const osg::GLExtensions& extensions = *state.get<osg::GLExtensions>();
    WorkingBatch working;
    working.batch = &batch;
    working.source = createBuffer(state, batch);

    working.lookup = GlTexture(state);
    glBindTexture(GL_TEXTURE_BUFFER, working.lookup.get());
    extensions.glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI_EXT, working.source.get());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    return working;
}

/** Whether the plan reads colours from the fine triangles; exact voxelization takes them from the source. */
bool needsColors(const PassPlan& plan)
{
    return plan.method == VoxelizationMethod::POINTS;
}

osg::ref_ptr<osg::Program> getProgram(bool hasColors)
{
    std::vector<const char*> captured{"finePosition", "fineTriangle"};
    if (hasColors) captured.insert(captured.end(), {"fineCoordinate", "fineColorAndLevel"});
    return ShaderLibrary::getProgram("subdivision", {"subdivision/subdivision.vert", "subdivision/subdivision.geom"},
                                     hasColors ? "#define HAS_COLORS\n" : "", captured);
}

} // namespace

SubdivisionPass::SubdivisionPass(PassWorkspace& workspace, const PassPlan& plan) :
    LegolizationPass(workspace, 0), _plan(plan)
{
    setStateSet(createPassState(*getProgram(needsColors(plan))));
    setCamera(new PassCamera(*this));
}

bool SubdivisionPass::begin(osg::State& state, PassContext& context) const
{
    return start(state, context, _plan);
}

std::string SubdivisionPass::run(osg::State& state, Legolization& work) const
{
    // Checked here, in the first pass, before any work that would be lost.
    if (std::string obstacle = PassPlan::findObstacle(*work.source); !obstacle.empty()) return obstacle;
    const double edgeLimit = work.source->settings.getEdgeLimit();
    ProgramUniforms(state).set("edgeLimit", static_cast<float>(edgeLimit));
    for (const GridBatch& batch : work.source->triangles->getBatches())
    {
        work.batches.push_back(upload(state, batch));
        WorkingBatch& working = work.batches.back();
        const std::optional<GridBatch> parts = cutToGrid(batch, *work.source->triangles, edgeLimit);
        if (parts) working.parts = createBuffer(state, *parts);
        const GridBatch& coarse = parts ? *parts : batch;
        working.numFineTriangles = static_cast<GLsizei>(coarse.getNumTriangles());
        if (static_cast<double>(coarse.longestEdge) > edgeLimit)
        {
            BatchSubdivision subdivision(state, coarse, working, edgeLimit, needsColors(_plan));
            if (std::string failure = subdivision.run(); !failure.empty()) return failure;
            work.statistics.numSubdivisionPasses =
                std::max(work.statistics.numSubdivisionPasses, subdivision.getNumPasses());
        }
        work.statistics.numFineTriangles += static_cast<std::size_t>(working.numFineTriangles);
    }
    return takeOutOfMemoryError() ? "there is not enough memory on the GPU for the source; expected a smaller mesh"
                                  : std::string();
}

} // namespace osgLego
