#include "BenchOptions.h"

#include <common/CompleteFile.h>

#include <stdexcept>

#include <fmt/format.h>

namespace osgLego
{

void BenchOptions::addTo(BenchCommand& command, const std::string& usualResolutions)
{
    command.addTexts("--mesh", meshes, "PATH or NAME=PATH, followed by ',up=y' if y is up; or 'car', which is built in",
                     "MESH...");
    command.addFolder("--models", models, "Folder of the meshes used without --mesh (build/models)");
    command.addNumbers("--resolution", resolutions, "Cells along the longest side (" + usualResolutions + ")", 1,
                       LegoSettings::MAXIMUM_RESOLUTION);
    command.addFlag("--quick", isQuick, "A short run that checks that everything works: the car at low resolutions");
    command.addText("--json", jsonFile, "Write the figures there (standard output)", "FILE");
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

void BenchOptions::write(const JsonValue& document) const
{
    const std::string text = document.toString(4) + '\n';
    if (jsonFile.empty())
    {
        fmt::print("{}", text);
        return;
    }
    const std::string why = writeCompleteFile(jsonFile,
                                              [&text](std::ostream& stream)
                                              {
                                                  stream << text;
                                                  return std::string();
                                              });
    if (!why.empty()) throw std::runtime_error("can't write '" + jsonFile + "': " + why);
}

void BenchRuns::addTo(BenchCommand& command)
{
    command.addNumber("--runs", numRuns, fmt::format("Timed runs ({})", numRuns), 1u, 10000u);
    command.addNumber("--warm-up", numWarmUps, fmt::format("Runs before these, not counted ({})", numWarmUps), 0u,
                      10000u);
}

} // namespace osgLego
