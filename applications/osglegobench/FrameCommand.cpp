#include "Commands.h"
#include "FrameBench.h"

#include <memory>
#include <string>

namespace osgLego
{

namespace
{

struct FrameOptions
{
    std::string models = "build/models";
    std::string pictures;
    int numFrames = 5;
};

} // namespace

void addFrameCommand(CLI::App& app)
{
    CLI::App* command = app.add_subcommand(
        "frame", "Drawing: the time of a frame, and its picture, beside every face and every stud drawn");
    const auto options = std::make_shared<FrameOptions>();
    command->add_option("--models", options->models, "The folder of bunny.ply (build/models)")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory);
    command->add_option("--frames", options->numFrames, "Frames of each kind (5)")->check(CLI::Range(1, 1000));
    command->add_option("--pictures", options->pictures, "A folder to write the pictures to")->type_name("FOLDER");
    command->callback([options] { printFrames(options->models, options->numFrames, options->pictures); });
}

} // namespace osgLego
