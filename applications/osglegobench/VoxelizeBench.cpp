#include "VoxelizeBench.h"

#include "StageTimes.h"

#include <offscreen/OffscreenContext.h>

#include <exception>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <osg/GL>

namespace osgLego
{

namespace
{

/** A contender on its way through a measurement. */
struct Entrant
{
    Contender* contender;
    std::vector<double> times;
    std::vector<std::pair<std::string, std::vector<double>>> stages;
    std::string failure;
};

void noteStages(Entrant& entrant)
{
    const auto* timed = dynamic_cast<const StageTimes*>(entrant.contender);
    if (!timed) return;
    const auto stages = timed->getStageTimes();
    entrant.stages.resize(stages.size());
    for (std::size_t stage = 0; stage < stages.size(); ++stage)
    {
        entrant.stages[stage].first = stages[stage].first;
        entrant.stages[stage].second.push_back(stages[stage].second);
    }
}

/** Let a contender do something, and take it out of the race when it can't. */
template <typename Function>
void attempt(Entrant& entrant, osg::GraphicsContext& context, const Function& function)
{
    if (!entrant.failure.empty()) return;
    try
    {
        context.makeCurrent();
        function();
    }
    catch (const std::exception& error)
    {
        entrant.failure = error.what();
    }
}

void runOnce(Entrant& entrant, osg::GraphicsContext& context, bool counts)
{
    attempt(entrant, context,
            [&]
            {
                // What the one before left to the renderer to do is no part of this one's time.
                glFinish();
                const double time = entrant.contender->run();
                if (!counts) return;
                entrant.times.push_back(time);
                noteStages(entrant);
            });
}

ContenderResult finish(const Entrant& entrant)
{
    ContenderResult result;
    result.contender = entrant.contender->getName();
    result.hasColors = entrant.contender->hasColors();
    result.failure = entrant.failure;
    if (!result.failure.empty()) return result;
    result.time = Spread::create(entrant.times);
    for (const auto& [name, times] : entrant.stages)
        result.stages.emplace_back(name, Spread::create(times).median);
    return result;
}

std::vector<Entrant> prepare(const BenchMesh& mesh, const ContenderList& contenders, osg::GraphicsContext& context)
{
    std::vector<Entrant> entrants;
    for (const auto& contender : contenders)
    {
        Entrant entrant{contender.get(), {}, {}, {}};
        attempt(entrant, context, [&] { entrant.failure = contender->prepare(mesh, context); });
        entrants.push_back(std::move(entrant));
    }
    return entrants;
}

void compareAll(const BenchMesh& mesh, std::vector<Entrant>& entrants, osg::GraphicsContext& context,
                MeshResult& result)
{
    const VoxelTruth truth(*mesh.triangles);
    result.numCells = truth.getNumCells();
    for (std::size_t index = 0; index < entrants.size(); ++index)
    {
        Entrant& entrant = entrants[index];
        attempt(entrant, context,
                [&]
                {
                    const osg::ref_ptr<const BrickModel> bricks = entrant.contender->getBricks();
                    result.contenders[index].quality = truth.compare(*bricks, entrant.contender->hasColors());
                });
        result.contenders[index].failure = entrant.failure;
    }
}

} // namespace

osg::ref_ptr<osg::GraphicsContext> createBenchContext()
{
    constexpr int SIZE = 16; // nothing is drawn to it
    std::string error;
    osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(SIZE, SIZE, error);
    if (!context) throw std::runtime_error(error);
    context->makeCurrent();
    return context;
}

MeshResult measureContenders(const BenchMesh& mesh, const ContenderList& contenders, const BenchRuns& runs,
                             osg::GraphicsContext& context, bool withQuality)
{
    MeshResult result;
    result.mesh = mesh.name;
    result.numTriangles = mesh.triangles->getNumTriangles();
    result.resolution = mesh.settings.resolution;
    result.dimensions = mesh.triangles->getGrid().dimensions;
    std::vector<Entrant> entrants = prepare(mesh, contenders, context);
    for (unsigned int run = 0; run < runs.numWarmUps + runs.numRuns; ++run)
        for (Entrant& entrant : entrants)
            runOnce(entrant, context, run >= runs.numWarmUps);
    for (const Entrant& entrant : entrants)
        result.contenders.push_back(finish(entrant));
    if (withQuality) compareAll(mesh, entrants, context, result);
    for (const Entrant& entrant : entrants)
    {
        context.makeCurrent();
        entrant.contender->release();
    }
    return result;
}

VoxelizeResults measureVoxelization(const VoxelizeOptions& options)
{
    const ContenderList contenders = createContenders(options.contenders);
    const osg::ref_ptr<osg::GraphicsContext> context = createBenchContext();
    VoxelizeResults results{BenchEnvironment::find(*context), options.runs.numRuns, options.runs.numWarmUps, {}};
    for (const MeshSource& source : options.meshes)
    {
        const osg::ref_ptr<osg::Node> node = readMesh(source);
        for (const unsigned int resolution : options.resolutions)
        {
            fmt::print(stderr, "measuring {} at {}\n", source.name, resolution);
            results.meshes.push_back(measureContenders(createBenchMesh(source, *node, resolution), contenders,
                                                       options.runs, *context, true));
        }
    }
    return results;
}

} // namespace osgLego
