#pragma once

#include "VoxelizeBench.h"

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace osgLego
{

/** The options that all subcommands share which measure contenders. */
struct MeasureOptions
{
    std::vector<std::string> meshes;
    std::string models = "build/models";
    std::optional<unsigned int> numRuns;
    std::optional<unsigned int> numWarmUps;
    bool isQuick = false;

    void addTo(CLI::App& command);

    /** Throws std::runtime_error. */
    std::vector<MeshSource> getMeshes() const;
    BenchRuns getRuns() const;
};

} // namespace osgLego
