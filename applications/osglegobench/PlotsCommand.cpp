#include "BenchFiles.h"
#include "Commands.h"
#include "Figures.h"
#include "MeasureOptions.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

struct PlotsOptions
{
    MeasureOptions measure;
    std::string folder;
    std::vector<std::string> figures{"6a", "6b", "scaling"};
    std::vector<std::string> contenders;
    unsigned int resolution = 128;
    std::vector<unsigned int> resolutions;
    std::vector<unsigned int> fboSizes;

    bool wants(const char* figure) const { return std::find(figures.begin(), figures.end(), figure) != figures.end(); }
};

/** What was given, or what is usual. */
std::vector<unsigned int> choose(const std::vector<unsigned int>& given, bool isQuick,
                                 const std::vector<unsigned int>& quick, const std::vector<unsigned int>& usual)
{
    if (!given.empty()) return given;
    return isQuick ? quick : usual;
}

void runPlots(const PlotsOptions& options)
{
    checkPlotting();
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    checkPlace(options.folder + "/plot.png");
    createContenders(options.contenders); // says so now, if one has another name
    const std::vector<MeshSource> meshes = options.measure.getMeshes();
    const BenchRuns runs = options.measure.getRuns();
    const bool isQuick = options.measure.isQuick;
    const std::vector<unsigned int> resolutions =
        choose(options.resolutions, isQuick, {16, 32}, {32, 64, 128, 256, 512});
    const osg::ref_ptr<osg::GraphicsContext> context = createBenchContext();
    const BenchEnvironment environment = BenchEnvironment::find(*context);
    const auto write = [&](const Plot& plot, const std::string& name)
    {
        writePlot(plot, environment, options.folder, name);
        fmt::print("{}/{}.png\n", options.folder, name);
    };
    if (options.wants("6a"))
        write(measureFboSizes(meshes, isQuick ? 32 : options.resolution,
                              choose(options.fboSizes, isQuick, {256, 512}, {256, 512, 1024, 2048, 4096}), runs,
                              *context),
              "figure-6a");
    if (options.wants("scaling"))
        for (const MeshSource& source : meshes)
        {
            write(measureTimes(source, resolutions, options.contenders, runs, *context), "time-" + source.name);
            write(measureFootprints(source, resolutions, options.contenders), "memory-" + source.name);
        }
    if (options.wants("6b")) write(measureFrameRates(meshes, resolutions, runs), "figure-6b");
}

} // namespace

void addPlotsCommand(CLI::App& app)
{
    CLI::App* command = app.add_subcommand(
        "plots", "Plots, and their numbers: the paper's Figures 6(a) and 6(b), time and memory over the resolution");
    const auto options = std::make_shared<PlotsOptions>();
    command->add_option("folder", options->folder, "Where they are written; made if need be")
        ->required()
        ->type_name("FOLDER");
    options->measure.addTo(*command);
    command->add_option("--figures", options->figures, "Only these: 6a, 6b, scaling")
        ->delimiter(',')
        ->check(CLI::IsMember({"6a", "6b", "scaling"}))
        ->type_name("NAME,...");
    command->add_option("--contenders", options->contenders, "Only these over the resolution, by their names")
        ->type_name("NAME...");
    command->add_option("--resolution", options->resolution, "Of figure 6a (128)")
        ->check(CLI::Range(1u, LegoSettings::MAXIMUM_RESOLUTION));
    command->add_option("--resolutions", options->resolutions, "Of all other figures (32,64,128,256,512)")
        ->delimiter(',')
        ->check(CLI::Range(1u, LegoSettings::MAXIMUM_RESOLUTION))
        ->type_name("N,...");
    command->add_option("--fbo", options->fboSizes, "Of figure 6a (256,512,1024,2048,4096)")
        ->delimiter(',')
        ->check(CLI::Range(LegoSettings::MINIMUM_FBO_SIZE, LegoSettings::MAXIMUM_FBO_SIZE))
        ->type_name("PIXELS,...");
    command->callback([options] { runPlots(*options); });
}

} // namespace osgLego
