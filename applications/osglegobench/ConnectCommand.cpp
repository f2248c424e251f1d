#include "BenchEnvironment.h"
#include "BenchMeshes.h"
#include "BenchOptions.h"
#include "Commands.h"

#include <osgLego/CpuLegolizer.h>
#include <osgLego/Stability.h>

#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace osgLego
{

namespace
{

constexpr double MOST_ADDED = 0.02; // the goal: cells that join pieces, as a share of all cells

struct ConnectCommandOptions : BenchOptions
{
    std::vector<std::string> meshes;
    std::vector<unsigned int> resolutions{24, 32, 48, 64};
    bool isPlates = false;
};

JsonValue measure(const MeshSource& mesh, osg::Node& node, unsigned int resolution, bool isPlates)
{
    LegoSettings settings;
    settings.grid.resolution = resolution;
    settings.grid.proportions = isPlates ? Proportions::PLATE : Proportions::BRICK;
    settings.grid.upAxis = mesh.upAxis;
    settings.parts.set = PartSet::BRICKS;
    settings.parts.connect = true;
    LegoStatistics statistics;
    const osg::ref_ptr<const BrickModel> model = legolizeOnCpu(node, settings, &statistics);
    if (!model) throw std::runtime_error("'" + mesh.name + "' can't be made of bricks");
    const LayoutStatistics& layout = *statistics.layout;
    const ConnectionStatistics& connection = *layout.connection;
    const auto numCells = static_cast<double>(layout.numCells - connection.numAddedCells);
    const StabilityReport report = *computeStability(*model);
    return {{"mesh", mesh.name},
            {"resolution", resolution},
            {"cells", layout.numCells},
            {"parts", layout.numParts},
            {"piecesBefore", connection.numPiecesBefore},
            {"pieces", connection.numPieces},
            {"added", static_cast<double>(connection.numAddedCells) / numCells},
            {"recolored", static_cast<double>(connection.numRecolored) / numCells},
            {"stands", report.stands},
            {"milliseconds", connection.milliseconds}};
}

void printRows(const JsonValue& rows)
{
    fmt::print("| model | cells | parts | pieces before | pieces | added cells | other colours | stands | ms |\n"
               "|---|---|---|---|---|---|---|---|---|\n");
    std::size_t numWhole = 0;
    std::size_t numFewAdded = 0;
    for (const JsonValue& row : rows.getElements())
    {
        const bool isWhole = row["pieces"].toInteger() == 1;
        const bool isFewAdded = row["added"].toNumber() <= MOST_ADDED;
        numWhole += isWhole ? 1 : 0;
        numFewAdded += isFewAdded ? 1 : 0;
        fmt::print("| {} {} | {} | {} | {} | {}{} | {:.1f} %{} | {:.1f} % | {} | {:.0f} |\n", row["mesh"].toText(),
                   row["resolution"].toInteger(), row["cells"].toInteger(), row["parts"].toInteger(),
                   row["piecesBefore"].toInteger(), row["pieces"].toInteger(), isWhole ? "" : "*",
                   100.0 * row["added"].toNumber(), isFewAdded ? "" : "*", 100.0 * row["recolored"].toNumber(),
                   row["stands"].toBoolean() ? "yes" : "no", row["milliseconds"].toNumber());
    }
    fmt::print("\nOf {} models, {} are one piece, and {} have at most 2 % added cells (*: more)\n",
               rows.getElements().size(), numWhole, numFewAdded);
}

void runConnect(const ConnectCommandOptions& options)
{
    std::vector<MeshSource> meshes;
    for (const std::string& mesh : options.meshes)
        meshes.push_back(MeshSource::parse(mesh));
    if (meshes.empty()) meshes = {MeshSource(), options.getMesh()};
    if (options.isQuick) meshes.resize(1);
    const std::vector<unsigned int> resolutions = options.isQuick ? std::vector<unsigned int>{24} : options.resolutions;
    JsonValue document = createDocument("connect");
    for (const MeshSource& mesh : meshes)
    {
        const osg::ref_ptr<osg::Node> node = readMesh(mesh);
        for (const unsigned int resolution : resolutions)
        {
            fmt::print(stderr, "joining the pieces of {} at {}\n", mesh.name, resolution);
            document["rows"].append(measure(mesh, *node, resolution, options.isPlates));
        }
    }
    if (!options.jsonFile.empty()) return options.write(document);
    printRows(document["rows"]);
}

} // namespace

void addConnectCommand(BenchCommandLine& commands)
{
    BenchCommand command =
        commands.add("connect", "Pieces of layouts before and after they are joined (connect=on), and the changes");
    const auto options = std::make_shared<ConnectCommandOptions>();
    command.addFolder("--models", options->models, "Folder of bunny.ply (build/models)");
    command.addTexts("--mesh", options->meshes,
                     "Meshes, each FILE, NAME=FILE or car, optionally followed by ,up=y (the car and the bunny)",
                     "MESH");
    command.addNumbers("--resolution", options->resolutions, "Cells along the longest side (24,32,48,64)", 1, 1024);
    command.addFlag("--plates", options->isPlates, "Lay plates instead of bricks");
    command.addFlag("--quick", options->isQuick, "A short run that checks that everything works");
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (a table on standard output)",
                    "FILE");
    command.setRun([options] { runConnect(*options); });
}

} // namespace osgLego
