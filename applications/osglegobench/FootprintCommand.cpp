#include "Commands.h"
#include "Footprint.h"
#include "SceneFootprint.h"

#include <memory>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

struct FootprintOptions
{
    std::string mesh;
    unsigned int resolution = 64;
    std::string contender;
    std::string device;
};

} // namespace

void addFootprintCommand(CLI::App& app)
{
    CLI::App* command =
        app.add_subcommand("footprint", "The megabytes that one contender, or a process that draws a frame, takes");
    command->group(""); // no word of it in --help
    const auto options = std::make_shared<FootprintOptions>();
    command->add_option("--mesh", options->mesh)->required();
    command->add_option("--resolution", options->resolution)->check(CLI::Range(1u, LegoSettings::MAXIMUM_RESOLUTION));
    CLI::Option* contender = command->add_option("--contender", options->contender);
    command->add_option("--frame-by", options->device)->excludes(contender);
    command->callback(
        [options]
        {
            const MeshSource source = MeshSource::parse(options->mesh);
            if (options->device.empty())
                fmt::print("{}\n", measureFootprint(source, options->resolution, options->contender));
            else
                fmt::print("{}\n", SceneFootprint::measure(source, options->resolution, options->device).toText());
        });
}

} // namespace osgLego
