#pragma once

#include "BenchCommand.h"
#include "BenchMeshes.h"

#include <common/JsonValue.h>

#include <string>
#include <vector>

namespace osgLego
{

/** The options that all subcommands share: meshes, resolutions, and the file to write to. */
struct BenchOptions
{
    std::vector<std::string> meshes;
    std::string models = "build/models";
    std::vector<unsigned int> resolutions;
    bool isQuick = false;
    std::string jsonFile;

    /** @param usualResolutions the default resolutions, for --help. */
    void addTo(BenchCommand& command, const std::string& usualResolutions);

    /** All meshes to measure. Throws std::runtime_error, also if the file can't be written, before hours of work. */
    std::vector<MeshSource> getMeshes() const;
    /** The only mesh of a subcommand that measures one: the first of --mesh, else the bunny or the car. As above. */
    MeshSource getMesh() const;
    /** The resolutions of --resolution or, without it, the defaults of a quick or normal run. */
    std::vector<unsigned int> getResolutions(const std::vector<unsigned int>& quick,
                                             const std::vector<unsigned int>& usual) const;

    /** Write a document to --json (an atomic write) or to standard output. Throws std::runtime_error. */
    void write(const JsonValue& document) const;

private:
    void checkFile() const;
};

/** The number of timed runs. */
struct BenchRuns
{
    unsigned int numRuns = 7;
    unsigned int numWarmUps = 2; //!< runs before these, which are not counted

    /** Add --runs and --warm-up. */
    void addTo(BenchCommand& command);
};

} // namespace osgLego
