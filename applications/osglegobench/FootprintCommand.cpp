#include "Commands.h"
#include "Footprint.h"

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
};

} // namespace

void addFootprintCommand(CLI::App& app)
{
    CLI::App* command = app.add_subcommand("footprint", "The megabytes that one contender takes");
    command->group(""); // no word of it in --help
    const auto options = std::make_shared<FootprintOptions>();
    command->add_option("--mesh", options->mesh)->required();
    command->add_option("--resolution", options->resolution)->check(CLI::Range(1u, LegoSettings::MAXIMUM_RESOLUTION));
    command->add_option("--contender", options->contender)->required();
    command->callback(
        [options]
        {
            const MeshSource source = MeshSource::parse(options->mesh);
            fmt::print("{}\n", measureFootprint(source, options->resolution, options->contender));
        });
}

} // namespace osgLego
