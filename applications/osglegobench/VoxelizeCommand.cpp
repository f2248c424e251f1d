#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "Contenders.h"
#include "ResidentMemory.h"
#include "Spread.h"
#include "VoxelTruth.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <osg/GL>

namespace osgLego
{

namespace
{

struct VoxelizeOptions : BenchOptions
{
    BenchRuns runs;
    std::vector<std::string> contenders;
    bool hasNoQuality = false;
    bool hasFootprint = false;
};

/** A contender in a measurement, and its results. A contender that fails drops out, and the others go on. */
class Entrant
{
public:
    Entrant(Contender& contender, const BenchMesh& mesh, osg::GraphicsContext& context) :
        _contender(&contender), _context(&context)
    {
        attempt([&] { _failure = contender.prepare(mesh, context); });
    }

    /** @param counts whether this run is more than a warm-up. */
    void run(bool counts)
    {
        attempt(
            [&]
            {
                glFinish(); // don't time unfinished commands of the previous contender
                const double time = _contender->run();
                if (counts) note(time, _contender->getStages());
            });
    }

    void compare(const VoxelTruth& truth)
    {
        attempt([&] { _quality = truth.compare(*_contender->getBricks(), _contender->hasColors()); });
    }

    /** Release the contender, and give its results. */
    JsonValue finish()
    {
        _context->makeCurrent();
        _contender->release();
        JsonValue result{{"name", _contender->getName()}, {"hasColors", _contender->hasColors()}};
        if (!_failure.empty())
        {
            result["failure"] = _failure;
            return result;
        }
        result["milliseconds"] = createSpread(_times);
        for (const auto& [name, times] : _stages)
            result["parts"][name] = createSpread(times)["median"];
        if (!_quality) return result;
        result["cells"] = _quality->numCells;
        result["precision"] = _quality->precision;
        result["recall"] = _quality->recall;
        result["tunnels"] = _quality->numTunnels;
        if (_quality->colorError) result["colorError"] = *_quality->colorError;
        return result;
    }

private:
    using StageTimes = std::pair<std::string, std::vector<double>>;

    template <typename Function>
    void attempt(const Function& function)
    {
        if (!_failure.empty()) return;
        try
        {
            _context->makeCurrent();
            function();
        }
        catch (const std::exception& error)
        {
            _failure = error.what();
        }
    }

    void note(double time, const Contender::Stages& stages)
    {
        _times.push_back(time);
        for (const auto& [name, milliseconds] : stages)
        {
            const auto stage = std::find_if(_stages.begin(), _stages.end(),
                                            [&name = name](const StageTimes& times) { return times.first == name; });
            if (stage != _stages.end())
                stage->second.push_back(milliseconds);
            else
                _stages.push_back({name, {milliseconds}});
        }
    }

    Contender* _contender;
    osg::GraphicsContext* _context;
    std::vector<double> _times;
    std::vector<StageTimes> _stages; //!< in the order of the contender
    std::optional<VoxelQuality> _quality;
    std::string _failure;
};

/** Run all contenders in turns, so that changes of the machine's load affect all equally. */
void runInTurns(std::vector<Entrant>& entrants, const BenchRuns& runs)
{
    for (unsigned int run = 0; run < runs.numWarmUps + runs.numRuns; ++run)
        for (Entrant& entrant : entrants)
            entrant.run(run >= runs.numWarmUps);
}

JsonValue measure(const BenchMesh& mesh, const ContenderList& contenders, const VoxelizeOptions& options,
                  osg::GraphicsContext& context)
{
    fmt::print(stderr, "measuring {} at {}\n", mesh.name, mesh.settings.grid.resolution);
    const glm::ivec3& dimensions = mesh.triangles->getGrid().dimensions;
    JsonValue result{{"mesh", mesh.name},
                     {"triangles", mesh.triangles->getNumTriangles()},
                     {"resolution", mesh.settings.grid.resolution},
                     {"dimensions", JsonValue::createArray({dimensions.x, dimensions.y, dimensions.z})}};
    std::vector<Entrant> entrants;
    for (const auto& contender : contenders)
        entrants.emplace_back(*contender, mesh, context);
    runInTurns(entrants, options.runs);
    if (!options.hasNoQuality)
    {
        const VoxelTruth truth(*mesh.triangles);
        result["coveredCells"] = truth.getNumCells();
        for (Entrant& entrant : entrants)
            entrant.compare(truth);
    }
    for (Entrant& entrant : entrants)
        result["contenders"].append(entrant.finish());
    return result;
}

/** Run contenders at a low resolution, so that memory that does not depend on the grid, such as compiled shaders, is
 * allocated before the peak is reset. */
double takePeakBefore(const MeshSource& source, osg::Node& node, const ContenderList& contenders,
                      osg::GraphicsContext& context)
{
    constexpr unsigned int LOW_RESOLUTION = 8;
    const BenchMesh mesh = createBenchMesh(source, node, LOW_RESOLUTION);
    for (const auto& contender : contenders)
    {
        Entrant entrant(*contender, mesh, context);
        entrant.run(true);
        entrant.run(true);
        entrant.finish();
    }
    resetPeakMemory();
    return readPeakMemory();
}

void runVoxelize(const VoxelizeOptions& options)
{
    const std::vector<MeshSource> sources = options.getMeshes();
    const ContenderList contenders = createContenders(options.contenders);
    if (options.hasFootprint && (contenders.size() != 1 || sources.size() != 1 || options.resolutions.size() != 1))
        throw std::runtime_error("--footprint measures a process; expected one --mesh, --resolution and --contenders");
    const osg::ref_ptr<osg::GraphicsContext> context = createBenchContext();
    JsonValue document = createDocument("voxelize", *context);
    document["runs"] = options.runs.numRuns;
    document["warmUps"] = options.runs.numWarmUps;
    for (const MeshSource& source : sources)
    {
        const osg::ref_ptr<osg::Node> node = readMesh(source);
        const double before = options.hasFootprint ? takePeakBefore(source, *node, contenders, *context) : 0.0;
        for (const unsigned int resolution : options.getResolutions({32}, {64, 128}))
            document["meshes"].append(
                measure(createBenchMesh(source, *node, resolution), contenders, options, *context));
        if (options.hasFootprint) document["mebibytes"] = readPeakMemory() - before;
    }
    options.write(document);
}

} // namespace

void addVoxelizeCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add(
        "voxelize", "Finding bricks: times, exactness and colours of this project's methods and of published ones");
    const auto options = std::make_shared<VoxelizeOptions>();
    options->addTo(command, "64,128");
    options->runs.addTo(command);
    command.addTexts("--contenders", options->contenders,
                     "Only these, by name, or settings of a LegoNode, such as 'method=points,fbo=512,device=gpu'",
                     "NAME...");
    command.addFlag("--no-quality", options->hasNoQuality, "Only time, since comparing cells takes long");
    command.addFlag("--footprint", options->hasFootprint,
                    "Measure by how many MiB the peak of resident memory grows, too; of a single contender");
    command.setRun([options] { runVoxelize(*options); });
}

} // namespace osgLego
