#include "Commands.h"

#include <exception>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace osgLego
{

namespace
{

int run(int argc, char** argv)
{
    CLI::App app{"Measures osgLego and writes figures as JSON; scripts/bench runs it and makes tables of them.",
                 "osglegobench"};
    app.require_subcommand(1);
    addVoxelizeCommand(app);
    addFrameCommand(app);
    addDrawCommand(app);
    addOcclusionCommand(app);
    addColorsCommand(app);
    addLayoutCommand(app);
    addStabilityCommand(app);
    addBuildingCommand(app);
    CLI11_PARSE(app, argc, argv);
    return 0;
}

} // namespace

} // namespace osgLego

int main(int argc, char** argv)
{
    try
    {
        return osgLego::run(argc, argv);
    }
    catch (const std::exception& error)
    {
        fmt::print(stderr, "osglegobench: {}\n", error.what());
        return 1;
    }
}
