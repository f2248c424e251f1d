#include "BenchOptions.h"

#include <common/CompleteFile.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

namespace osgLego
{

void BenchOptions::addTo(CLI::App& command, const std::string& usualResolutions)
{
    command
        .add_option("--mesh", meshes, "PATH or NAME=PATH, followed by ',up=y' if y is up; or 'car', which is built in")
        ->type_name("MESH...");
    command.add_option("--models", models, "Folder of the meshes used without --mesh (build/models)")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory);
    command.add_option("--resolution", resolutions, "Cells along the longest side (" + usualResolutions + ")")
        ->delimiter(',')
        ->check(CLI::Range(1u, LegoSettings::MAXIMUM_RESOLUTION))
        ->type_name("N,...");
    command.add_flag("--quick", isQuick, "A short run that checks that everything works: the car at low resolutions");
    command.add_option("--json", jsonFile, "Write the figures there (standard output)")->type_name("FILE");
}

void BenchOptions::checkFile() const
{
    if (jsonFile.empty()) return;
    if (const std::string obstacle = findObstacleToWriting(jsonFile); !obstacle.empty())
        throw std::runtime_error("can't write '" + jsonFile + "': " + obstacle);
}

std::vector<MeshSource> BenchOptions::getMeshes() const
{
    checkFile();
    if (meshes.empty()) return isQuick ? std::vector{MeshSource()} : findMeshSources(models);
    std::vector<MeshSource> sources;
    for (const std::string& text : meshes)
        sources.push_back(MeshSource::parse(text));
    return sources;
}

MeshSource BenchOptions::getMesh() const
{
    checkFile();
    if (!meshes.empty()) return MeshSource::parse(meshes.front());
    return isQuick ? MeshSource() : findBunny(models);
}

std::vector<unsigned int> BenchOptions::getResolutions(const std::vector<unsigned int>& quick,
                                                       const std::vector<unsigned int>& usual) const
{
    if (!resolutions.empty()) return resolutions;
    return isQuick ? quick : usual;
}

void BenchOptions::write(const nlohmann::ordered_json& document) const
{
    const std::string text = document.dump(4) + '\n';
    if (jsonFile.empty())
    {
        fmt::print("{}", text);
        return;
    }
    const std::string why = writeCompleteFile(jsonFile,
                                              [&text](const std::string& temporaryName)
                                              {
                                                  std::ofstream file(temporaryName, std::ios::binary);
                                                  file << text;
                                                  file.close();
                                                  return file ? std::string() : std::string(std::strerror(errno));
                                              });
    if (!why.empty()) throw std::runtime_error("can't write '" + jsonFile + "': " + why);
}

void BenchRuns::addTo(CLI::App& command)
{
    command.add_option("--runs", numRuns, fmt::format("Timed runs ({})", numRuns))->check(CLI::Range(1u, 10000u));
    command.add_option("--warm-up", numWarmUps, fmt::format("Runs before these, not counted ({})", numWarmUps))
        ->check(CLI::Range(0u, 10000u));
}

} // namespace osgLego
