#include "BenchMeshes.h"
#include "Commands.h"
#include "FrameBench.h"
#include "FrameReport.h"
#include "ReportFiles.h"
#include "SharedOptions.h"

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace osgLego
{

namespace
{

struct FrameCommandOptions
{
    std::string models = "build/models";
    std::string pictures;
    std::vector<unsigned int> resolutions;
    unsigned int numFrames = 5;
    bool isQuick = false;
    ReportFiles files;
};

void runFrame(const FrameCommandOptions& options)
{
    options.files.check();
    if (!options.pictures.empty() && !std::filesystem::is_directory(options.pictures))
        throw std::runtime_error("there is no folder '" + options.pictures + "'");
    FrameOptions measured;
    measured.mesh = options.isQuick ? MeshSource::parse("car") : findBunny(options.models);
    measured.resolutions = options.resolutions;
    if (measured.resolutions.empty())
        measured.resolutions =
            options.isQuick ? std::vector<unsigned int>{16} : std::vector<unsigned int>{64, 128, 256};
    if (options.isQuick) measured.size = {160, 90};
    measured.numFrames = options.isQuick ? 1 : options.numFrames;
    measured.pictureFolder = options.pictures;
    options.files.report(measureFrames(measured));
}

} // namespace

void addFrameCommand(CLI::App& app)
{
    CLI::App* command = app.add_subcommand(
        "frame", "Drawing: the time of a frame, and its picture, beside every face and every stud drawn; and what "
                 "happens in frames in which nothing has changed");
    const auto options = std::make_shared<FrameCommandOptions>();
    addModelsOption(*command, options->models, "bunny.ply");
    addResolutionOption(*command, options->resolutions, "64,128,256");
    command->add_option("--frames", options->numFrames, "Frames of each kind (5)")->check(CLI::Range(1u, 1000u));
    command->add_option("--pictures", options->pictures, "A folder to write the pictures to")->type_name("FOLDER");
    command->add_flag("--quick", options->isQuick, "Little, to see that it works: the car at 16, small, one frame");
    options->files.addTo(*command);
    command->callback([options] { runFrame(*options); });
}

} // namespace osgLego
