#include "BenchEnvironment.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "NodesMemory.h"

#include <memory>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

constexpr unsigned int QUICK_NUM_NODES = 16;

struct NodesCommandOptions : BenchOptions
{
    unsigned int numNodes = 1024;
    std::string picture;
};

void runNodesCommand(const NodesCommandOptions& options)
{
    const unsigned int numNodes = options.isQuick ? QUICK_NUM_NODES : options.numNodes;
    JsonValue document = createDocument("nodes-memory");
    for (const SmallSource source : {SmallSource::STORED, SmallSource::MESH, SmallSource::SAMPLE})
    {
        fmt::print(stderr, "measuring {} nodes\n", numNodes);
        document["rows"].append(
            measureNodesMemory(source, numNodes, source == SmallSource::STORED ? options.picture : std::string()));
    }
    if (!options.jsonFile.empty()) return options.write(document);
    printNodesMemory(document);
}

} // namespace

void addNodesCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add("nodes", "The memory of each of many nodes with five bricks, in one viewer");
    const auto options = std::make_shared<NodesCommandOptions>();
    command.addNumber("--nodes", options->numNodes, "Nodes (1024)", 1u, 100000u);
    command.addText("--picture", options->picture, "Write a picture of the nodes there", "FILE");
    command.addFlag("--quick", options->isQuick, "A short run that checks that everything works");
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (a table on standard output)",
                    "FILE");
    command.setRun([options] { runNodesCommand(*options); });
}

} // namespace osgLego
