#include "Commands.h"
#include "MemoryReport.h"
#include "ReportFiles.h"
#include "SharedOptions.h"
#include "VoxelizeBench.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

struct MemoryOptions
{
    std::string mesh;
    std::string models = "build/models";
    std::vector<unsigned int> resolutions;
    std::vector<std::string> devices{"auto", "gpu"};
    bool isQuick = false;
    ReportFiles files;

    MeshSource getMesh() const
    {
        if (!mesh.empty()) return MeshSource::parse(mesh);
        return isQuick ? MeshSource::parse("car") : findBunny(models);
    }
    std::vector<unsigned int> getResolutions() const
    {
        if (resolutions.empty())
            return isQuick ? std::vector<unsigned int>{16, 32}
                           : std::vector<unsigned int>{LegoSettings::MAXIMUM_RESOLUTION / 2,
                                                       LegoSettings::MAXIMUM_RESOLUTION};
        std::vector<unsigned int> sorted = resolutions;
        std::sort(sorted.begin(), sorted.end());
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        return sorted;
    }
};

void runMemory(const MemoryOptions& options)
{
    options.files.check();
    const MeshSource source = options.getMesh();
    readMesh(source); // so that what can't be read is said once, and before anything is measured
    MemoryResults results{BenchEnvironment::find(*createBenchContext()), source.name, {}};
    for (const std::string& device : options.devices)
        for (const unsigned int resolution : options.getResolutions())
        {
            fmt::print(stderr, "measuring {} at {} with device={}\n", source.name, resolution, device);
            results.rows.push_back({device, resolution, SceneFootprint::measureApart(source, resolution, device)});
        }
    if (std::none_of(results.rows.begin(), results.rows.end(), [](const MemoryRow& row) { return row.footprint; }))
        throw std::runtime_error("no frame of '" + source.name + "' could be drawn; allowed: a mesh that can be read");
    options.files.report(results);
}

} // namespace

void addMemoryCommand(CLI::App& app)
{
    CLI::App* command = app.add_subcommand("memory", "Memory at 1024 cells along a side, and at half of that, and what "
                                                     "of it is largest; takes a minute or more on a "
                                                     "software renderer");
    const auto options = std::make_shared<MemoryOptions>();
    command
        ->add_option("--mesh", options->mesh,
                     "PATH or NAME=PATH, with ',up=y' behind it if the mesh stands so; or 'car', the built-in one "
                     "(bunny.ply of --models, or the car)")
        ->type_name("MESH");
    addModelsOption(*command, options->models, "bunny.ply");
    addResolutionOption(*command, options->resolutions, "512,1024");
    command->add_option("--device", options->devices, "What finds the bricks: auto, gpu, cpu (auto,gpu)")
        ->delimiter(',')
        ->check(CLI::IsMember({"auto", "gpu", "cpu"}))
        ->type_name("NAME,...");
    command->add_flag("--quick", options->isQuick, "Little, to see that it works: the car at 16 and 32");
    options->files.addTo(*command);
    command->callback([options] { runMemory(*options); });
}

} // namespace osgLego
