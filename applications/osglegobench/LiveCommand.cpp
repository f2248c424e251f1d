#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "CancellationTimes.h"
#include "Commands.h"
#include "MotionTimes.h"
#include "ScalingTimes.h"

#include <memory>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

const std::vector<std::string> USUAL_SETTINGS{"256",
                                              "128,palette=ldraw,dither=on",
                                              "64,parts=bricks,show=load",
                                              "96,parts=bricks,fill=solid,effort=best",
                                              "48,parts=bricks,proportions=plate,effort=best",
                                              "32,parts=bricks,support=on"};

const std::vector<std::string> LAID_SETTINGS{"64,parts=bricks", "64,parts=bricks,fill=solid",
                                             "96,parts=bricks,fill=solid", "48,parts=bricks,proportions=plate"};

const std::vector<std::string> MOVING_SETTINGS{"64", "64,parts=bricks,effort=instant", "64,parts=bricks"};

struct LiveCommandOptions : BenchOptions
{
    std::vector<std::string> settings;
    unsigned int numRuns = 40;
};

void printCancellations(const JsonValue& rows)
{
    fmt::print("| cancelled | within s | median ms | longest ms | goal |\n|---|---|---|---|---|\n");
    for (const JsonValue& row : rows.getElements())
        fmt::print("| {} {} | {:.2f} | {:.1f} | {:.1f} | {:.0f} |\n", row["mesh"].toText(), row["settings"].toText(),
                   row["seconds"].toNumber(), row["latency"]["median"].toNumber(), row["latency"]["maximum"].toNumber(),
                   row["goals"].getElements().front()["goal"].toNumber());
}

void printScaling(const JsonValue& rows)
{
    fmt::print("\n| laid | on one thread s | on two s | ratio | goal |\n|---|---|---|---|---|\n");
    for (const JsonValue& row : rows.getElements())
        fmt::print("| {} {} | {:.2f} | {:.2f} | {:.2f} ({:.2f} to {:.2f}) | {} |\n", row["mesh"].toText(),
                   row["settings"].toText(), row["one"]["median"].toNumber(), row["two"]["median"].toNumber(),
                   row["ratio"]["median"].toNumber(), row["ratio"]["lowerQuartile"].toNumber(),
                   row["ratio"]["upperQuartile"].toNumber(), row["goals"].getElements().front()["goal"].toNumber());
}

void printMotion(const JsonValue& rows)
{
    fmt::print("\n| moves | cores | brick sets per s | goal | frames per s | of the still model | ratio | goal |\n"
               "|---|---|---|---|---|---|---|---|\n");
    for (const JsonValue& row : rows.getElements())
    {
        const std::vector<JsonValue> goals = row["goals"].getElements();
        fmt::print("| {} {} | {} | {:.1f} | {} | {:.0f} | {:.0f} | {:.2f} ({:.2f} to {:.2f}) | {} |\n",
                   row["mesh"].toText(), row["settings"].toText(), row["cores"].toInteger(),
                   row["setsPerSecond"]["median"].toNumber(), goals[0]["goal"].toNumber(),
                   row["framesPerSecond"]["median"].toNumber(), row["stillFramesPerSecond"]["median"].toNumber(),
                   row["ratio"]["median"].toNumber(), row["ratio"]["lowerQuartile"].toNumber(),
                   row["ratio"]["upperQuartile"].toNumber(), goals[1]["goal"].toNumber());
    }
}

void runLive(const LiveCommandOptions& options)
{
    constexpr double MOST_SECONDS = 4.0;
    constexpr unsigned int NUM_LAYOUTS = 5; // on each number of threads
    const MeshSource bunny = options.getMesh();
    std::vector<std::string> settings = options.settings;
    if (settings.empty()) settings = options.isQuick ? std::vector<std::string>{"32,parts=bricks"} : USUAL_SETTINGS;
    JsonValue document = createDocument("live");
    for (const std::string& text : settings)
    {
        fmt::print(stderr, "cancelling {}, {}\n", bunny.name, text);
        document["cancellations"].append(
            measureCancellation(bunny, text, options.isQuick ? 3 : options.numRuns, MOST_SECONDS));
    }
    std::vector<std::string> laid = options.settings;
    if (laid.empty()) laid = options.isQuick ? std::vector<std::string>{"16,parts=bricks"} : LAID_SETTINGS;
    for (const std::string& text : laid)
    {
        fmt::print(stderr, "laying {}, {}\n", bunny.name, text);
        document["scaling"].append(measureScaling(bunny, text, options.isQuick ? 1 : NUM_LAYOUTS));
    }
    std::vector<std::string> moving = options.settings;
    if (moving.empty()) moving = options.isQuick ? std::vector<std::string>{"16,parts=bricks"} : MOVING_SETTINGS;
    for (const std::string& text : moving)
    {
        fmt::print(stderr, "moving {}, {}\n", bunny.name, text);
        document["motion"].append(options.isQuick ? measureMotion(bunny, text, 1, 0.2)
                                                  : measureMotion(bunny, text, 5, 4.0));
    }
    if (!options.jsonFile.empty()) return options.write(document);
    printCancellations(document["cancellations"]);
    printScaling(document["scaling"]);
    printMotion(document["motion"]);
}

} // namespace

void addLiveCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add("live", "The milliseconds to cancel a legolization, its times on one thread "
                                                "and two, and the brick sets per second of a "
                                                "mesh that moves");
    const auto options = std::make_shared<LiveCommandOptions>();
    command.addTexts("--mesh", options->meshes, "Mesh to measure (the bunny)", "MESH");
    command.addFolder("--models", options->models, "Folder of bunny.ply (build/models)");
    command.addTexts("--settings", options->settings, "Settings to measure (six to cancel, four to lay, three to move)",
                     "SETTINGS");
    command.addNumber("--runs", options->numRuns, "Cancellations of each legolization (40)", 1u, 1000u);
    command.addFlag("--quick", options->isQuick, "A short run that checks that everything works");
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (a table on standard output)",
                    "FILE");
    command.setRun([options] { runLive(*options); });
}

} // namespace osgLego
