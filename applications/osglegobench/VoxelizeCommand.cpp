#include "Commands.h"
#include "MeasureOptions.h"
#include "ReportFiles.h"
#include "SharedOptions.h"
#include "VoxelizeBench.h"
#include "VoxelizeReport.h"

#include <memory>

namespace osgLego
{

namespace
{

struct VoxelizeCommandOptions
{
    MeasureOptions measure;
    std::vector<unsigned int> resolutions;
    std::vector<std::string> contenders;
    ReportFiles files;
};

void runVoxelize(const VoxelizeCommandOptions& options)
{
    options.files.check();
    VoxelizeOptions measured{options.measure.getMeshes(), options.resolutions, options.measure.getRuns(),
                             options.contenders};
    if (measured.resolutions.empty())
        measured.resolutions =
            options.measure.isQuick ? std::vector<unsigned int>{32} : std::vector<unsigned int>{64, 128};
    options.files.report(measureVoxelization(measured));
}

} // namespace

void addVoxelizeCommand(CLI::App& app)
{
    CLI::App* command = app.add_subcommand(
        "voxelize", "Finding bricks: times, exactness and colours of this project's methods and of others");
    const auto options = std::make_shared<VoxelizeCommandOptions>();
    options->measure.addTo(*command);
    addResolutionOption(*command, options->resolutions, "64,128");
    command->add_option("--contenders", options->contenders, "Only these, by their names in the table")
        ->type_name("NAME...");
    options->files.addTo(*command);
    command->callback([options] { runVoxelize(*options); });
}

} // namespace osgLego
