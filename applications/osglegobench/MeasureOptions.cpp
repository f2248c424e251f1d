#include "MeasureOptions.h"

#include "SharedOptions.h"

namespace osgLego
{

void MeasureOptions::addTo(CLI::App& command)
{
    command
        .add_option("--mesh", meshes,
                    "PATH or NAME=PATH, with ',up=y' behind it if the mesh stands so; or 'car', the built-in one "
                    "(the car and every .ply and .dae of --models)")
        ->type_name("MESH...");
    addModelsOption(command, models, "meshes");
    command.add_option("--runs", numRuns, "How often all of them run (7)")->check(CLI::Range(1u, 10000u));
    command.add_option("--warm-up", numWarmUps, "Runs before, which do not count (2)")->check(CLI::Range(0u, 10000u));
    command.add_flag("--quick", isQuick, "Little, to see that it works: the car, few runs, low resolutions");
}

std::vector<MeshSource> MeasureOptions::getMeshes() const
{
    if (meshes.empty()) return isQuick ? std::vector{MeshSource::parse("car")} : findMeshSources(models);
    std::vector<MeshSource> sources;
    for (const std::string& text : meshes)
        sources.push_back(MeshSource::parse(text));
    return sources;
}

BenchRuns MeasureOptions::getRuns() const
{
    const BenchRuns usual = isQuick ? BenchRuns{1, 1} : BenchRuns();
    return {numRuns.value_or(usual.numRuns), numWarmUps.value_or(usual.numWarmUps)};
}

} // namespace osgLego
