#include "BenchEnvironment.h"
#include "BenchMeshes.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "JoinedParts.h"
#include "PlanFigures.h"
#include "Spread.h"

#include <osgLego/BuildingPlanner.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/stability/ContactFinder.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>
#include <osg/Timer>

namespace osgLego
{

namespace
{

using Parts = std::vector<std::uint32_t>;

// The order that is compared with the plan: layer by layer, in steps of this many parts.
constexpr std::size_t LAYER_STEP_PARTS = 8;

struct BuildingCommandOptions : BenchOptions
{
    unsigned int numRuns = 3;
    std::string settings = "32,parts=bricks";
};

/** A model to plan. */
struct BuildingCase
{
    MeshSource mesh;
    std::string settings;
};

/** Finds the steps after which parts are in place that no joints connect to the base. */
class FloatingSteps
{
public:
    explicit FloatingSteps(const BrickModel& model) : _boxes(findPartBoxes(model)), _neighbours(findJoinedParts(model))
    {
        for (const PartBox& box : _boxes)
            _lowest = std::min(_lowest, box.low.z);
    }

    /** All parts but `ignored`, layer by layer. */
    std::vector<Parts> findLayerSteps(const Parts& ignored) const
    {
        Parts order(_boxes.size());
        std::iota(order.begin(), order.end(), 0u);
        std::erase_if(order,
                      [&](std::uint32_t part) { return std::binary_search(ignored.begin(), ignored.end(), part); });
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t left, std::uint32_t right)
                         { return _boxes[left].low.z < _boxes[right].low.z; });
        std::vector<Parts> steps;
        for (std::size_t first = 0; first < order.size(); first += LAYER_STEP_PARTS)
            steps.emplace_back(order.begin() + static_cast<std::ptrdiff_t>(first),
                               order.begin() +
                                   static_cast<std::ptrdiff_t>(std::min(first + LAYER_STEP_PARTS, order.size())));
        return steps;
    }

    std::size_t count(const std::vector<Parts>& steps) const
    {
        std::vector<bool> isPlaced(_boxes.size());
        std::size_t numPlaced = 0;
        std::size_t numFloating = 0;
        for (const Parts& step : steps)
        {
            for (const std::uint32_t part : step)
                isPlaced[part] = true;
            numPlaced += step.size();
            if (countHeld(isPlaced) < numPlaced) ++numFloating;
        }
        return numFloating;
    }

private:
    std::size_t countHeld(const std::vector<bool>& isPlaced) const
    {
        Parts held;
        std::vector<bool> isHeld(_boxes.size());
        const auto hold = [&](std::uint32_t part)
        {
            if (!isPlaced[part] || isHeld[part]) return;
            isHeld[part] = true;
            held.push_back(part);
        };
        for (std::uint32_t part = 0; part < _boxes.size(); ++part)
            if (_boxes[part].low.z == _lowest) hold(part);
        for (std::size_t next = 0; next < held.size(); ++next)
            for (const std::uint32_t neighbour : _neighbours[held[next]])
                hold(neighbour);
        return held.size();
    }

    std::vector<PartBox> _boxes;
    std::vector<Parts> _neighbours; //!< by studs
    int _lowest = 0;
};

osg::ref_ptr<const BrickModel> lay(const BuildingCase& buildingCase)
{
    LegoSettings settings;
    std::string error;
    if (!LegoSettings::parse(buildingCase.settings + (buildingCase.mesh.upAxis == UpAxis::Y ? ",up=y" : ",up=z"),
                             settings, error))
        throw std::runtime_error(error);
    osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*readMesh(buildingCase.mesh), settings);
    if (!model) throw std::runtime_error("'" + buildingCase.mesh.path + "' can't be legolized");
    return model;
}

/** Plan a model several times, and keep the times. */
osg::ref_ptr<const BuildingPlan> plan(const BrickModel& model, bool checksStability, unsigned int numRuns,
                                      std::vector<double>& milliseconds)
{
    PlanningOptions options;
    options.checksStability = checksStability;
    osg::ref_ptr<const BuildingPlan> result;
    for (unsigned int run = 0; run < numRuns; ++run)
    {
        const osg::Timer_t start = osg::Timer::instance()->tick();
        result = planBuilding(model, options);
        milliseconds.push_back(osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick()));
    }
    return result;
}

std::size_t countFalling(const std::vector<BuildingStep>& steps)
{
    return static_cast<std::size_t>(
        std::count_if(steps.begin(), steps.end(), [](const BuildingStep& step) { return !step.stands; }));
}

JsonValue measure(const BuildingCase& buildingCase, unsigned int numRuns)
{
    const osg::ref_ptr<const BrickModel> model = lay(buildingCase);
    std::vector<double> orderTimes;
    std::vector<double> stabilityTimes;
    plan(*model, false, numRuns, orderTimes);
    const osg::ref_ptr<const BuildingPlan> checked = plan(*model, true, numRuns, stabilityTimes);
    // Parts that can't be placed come last.
    const Parts unheld = checked->getUnheldParts();
    std::vector<Parts> steps;
    std::size_t numFalling = 0;
    for (const BuildingStep& step : checked->getSteps())
    {
        Parts placed = checked->getPlacedParts(step);
        if (std::erase_if(placed, [&](std::uint32_t part)
                          { return std::binary_search(unheld.begin(), unheld.end(), part); }) == 0 &&
            !step.stands)
            ++numFalling;
        if (!placed.empty()) steps.push_back(placed);
    }
    std::size_t numSubmodelSteps = 0;
    std::size_t numFallingSubmodelSteps = 0;
    for (const Submodel& submodel : checked->getSubmodels())
    {
        numSubmodelSteps += submodel.steps.size();
        numFallingSubmodelSteps += countFalling(submodel.steps);
    }
    const PlanFigures figures(*model, *checked);
    const FloatingSteps floating(*model);
    const std::vector<Parts> layerSteps = floating.findLayerSteps(unheld);
    return {{"mesh", buildingCase.mesh.name},
            {"settings", buildingCase.settings},
            {"parts", model->getParts().size()},
            {"unheld", unheld.size()},
            {"layerSteps", layerSteps.size()},
            {"floatingLayerSteps", floating.count(layerSteps)},
            {"steps", steps.size()},
            {"floatingSteps", floating.count(steps)},
            {"fallingSteps", numFalling},
            {"submodels", checked->getSubmodels().size()},
            {"submodelSteps", numSubmodelSteps},
            {"fallingSubmodelSteps", numFallingSubmodelSteps},
            {"pairs", figures.numPairs},
            {"deepestSubmodel", checked->getDeepestSubmodel()},
            {"largestSubmodel", checked->getLargestSubmodel()},
            {"looseParts", figures.mostLooseParts},
            {"fallingPieces", figures.numFallingPieces},
            {"uncheckedSteps", checked->getNumUnchecked()},
            {"milliseconds", createSpread(orderTimes)},
            {"stabilityMilliseconds", createSpread(stabilityTimes)}};
}

void printRows(const JsonValue& rows)
{
    fmt::print(
        "| model | parts, not placeable | layer by layer: steps that float | planned: steps that float | that fall "
        "| submodels, of two parts, nested, parts of the largest | their steps that fall | most parts that lie "
        "loose | pieces that fall | unchecked | ms | with stability, ms |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const JsonValue& row : rows.getElements())
        fmt::print("| {} {} | {}, {} | {} of {} | {} of {} | {} | {}, {}, {}, {} | {} of {} | {} | {} | {} | {:.0f} | "
                   "{:.0f} |\n",
                   row["mesh"].toText(), row["settings"].toText(), row["parts"].toInteger(), row["unheld"].toInteger(),
                   row["floatingLayerSteps"].toInteger(), row["layerSteps"].toInteger(),
                   row["floatingSteps"].toInteger(), row["steps"].toInteger(), row["fallingSteps"].toInteger(),
                   row["submodels"].toInteger(), row["pairs"].toInteger(), row["deepestSubmodel"].toInteger(),
                   row["largestSubmodel"].toInteger(), row["fallingSubmodelSteps"].toInteger(),
                   row["submodelSteps"].toInteger(), row["looseParts"].toInteger(), row["fallingPieces"].toInteger(),
                   row["uncheckedSteps"].toInteger(), row["milliseconds"]["median"].toNumber(),
                   row["stabilityMilliseconds"]["median"].toNumber());
}

void runBuilding(const BuildingCommandOptions& options)
{
    const MeshSource bunny = options.getMesh();
    const MeshSource car;
    std::vector<BuildingCase> cases{{car, "24,parts=bricks"},
                                    {car, "32,parts=bricks"},
                                    {bunny, "24,parts=bricks,colors=1"},
                                    {bunny, "32,parts=bricks,colors=1"},
                                    {bunny, "32,parts=bricks,proportions=plate,colors=1"}};
    if (options.isQuick) cases.resize(1);
    if (!options.meshes.empty()) cases.clear();
    for (const std::string& mesh : options.meshes)
        cases.push_back({MeshSource::parse(mesh), options.settings});
    JsonValue document = createDocument("building");
    for (const BuildingCase& buildingCase : cases)
    {
        fmt::print(stderr, "planning {}, {}\n", buildingCase.mesh.name, buildingCase.settings);
        document["rows"].append(measure(buildingCase, options.isQuick ? 1 : options.numRuns));
    }
    if (!options.jsonFile.empty()) return options.write(document);
    printRows(document["rows"]);
}

} // namespace

void addBuildingCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add(
        "building",
        "Building orders beside the order layer by layer: steps with floating parts, submodels, and the time");
    const auto options = std::make_shared<BuildingCommandOptions>();
    command.addFolder("--models", options->models, "Folder of bunny.ply (build/models)");
    command.addTexts("--mesh", options->meshes, "PATH or NAME=PATH, followed by ',up=y' if y is up; or 'car'",
                     "MESH...");
    command.addText("--settings", options->settings, "Settings of the bricks of --mesh (32,parts=bricks)", "SETTINGS");
    command.addNumber("--runs", options->numRuns, "Timed runs (3)", 1u, 100u);
    command.addFlag("--quick", options->isQuick, "A short run that checks that everything works");
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (a table on standard output)",
                    "FILE");
    command.setRun([options] { runBuilding(*options); });
}

} // namespace osgLego
