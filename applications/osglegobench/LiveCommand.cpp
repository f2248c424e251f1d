#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "CancellationTimes.h"
#include "Commands.h"
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
    if (!options.jsonFile.empty()) return options.write(document);
    printCancellations(document["cancellations"]);
    printScaling(document["scaling"]);
}

} // namespace

void addLiveCommand(BenchCommandLine& commands)
{
    BenchCommand command =
        commands.add("live", "The milliseconds to cancel a legolization, and its times on one thread and two");
    const auto options = std::make_shared<LiveCommandOptions>();
    command.addTexts("--mesh", options->meshes, "Mesh to measure (the bunny)", "MESH");
    command.addFolder("--models", options->models, "Folder of bunny.ply (build/models)");
    command.addTexts("--settings", options->settings, "Settings to measure (six to cancel, four to lay)", "SETTINGS");
    command.addNumber("--runs", options->numRuns, "Cancellations of each legolization (40)", 1u, 1000u);
    command.addFlag("--quick", options->isQuick, "A short run that checks that everything works");
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (a table on standard output)",
                    "FILE");
    command.setRun([options] { runLive(*options); });
}

} // namespace osgLego
