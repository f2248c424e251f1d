#include "Commands.h"

#include <exception>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

int run(int argc, char** argv)
{
    CLI::App app{"Measures osgLego.", "osglegobench"};
    app.require_subcommand(1);
    addOcclusionCommand(app);
    addVoxelizeCommand(app);
    addFrameCommand(app);
    addMemoryCommand(app);
    addPlotsCommand(app);
    addFootprintCommand(app);
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
