#include "Commands.h"

#include <exception>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

int run(int argc, char** argv)
{
    BenchCommandLine commands(
        "Measures osgLego and writes figures as JSON; scripts/bench runs it and makes tables of them.", "osglegobench");
    addVoxelizeCommand(commands);
    addFrameCommand(commands);
    addDrawCommand(commands);
    addOcclusionCommand(commands);
    addColorsCommand(commands);
    addLayoutCommand(commands);
    addStabilityCommand(commands);
    addBuildingCommand(commands);
    addConnectCommand(commands);
    addLiveCommand(commands);
    addNodesCommand(commands);
    addSoakCommand(commands);
    return commands.run(argc, argv);
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
