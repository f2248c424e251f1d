#include "BenchEnvironment.h"
#include "BenchMeshes.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "FactorizationTimes.h"
#include "ResidentMemory.h"
#include "Spread.h"

#include <osgLego/CpuLegolizer.h>
#include <osgLego/Stability.h>
#include <osgLego/stability/ContactFinder.h>
#include <osgLego/stability/EquilibriumProgram.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include <Clp_C_Interface.h>
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <osg/Timer>

namespace osgLego
{

namespace
{

// CLP takes more than five minutes for 5,000 parts.
constexpr std::size_t MOST_CLP_PARTS = 2000;
// Eigen's factorization of a solid of 20,000 parts takes minutes.
constexpr std::size_t MOST_COMPARED_PARTS = 10000;
constexpr double MOST_MEMORY = 4096.0; // MiB

struct StabilityCommandOptions : BenchOptions
{
    unsigned int numRuns = 5;
    bool usesClp = true;
    bool measuresSolid = false;
};

/** A number of cells along the mesh, and the maximum time in milliseconds for a model of that resolution. */
struct StabilityGoal
{
    unsigned int resolution;
    double milliseconds;
    Fill fill = Fill::SURFACE;
};

osg::ref_ptr<const BrickModel> lay(const MeshSource& mesh, const StabilityGoal& goal)
{
    LegoSettings settings;
    settings.grid.resolution = goal.resolution;
    settings.grid.proportions = Proportions::BRICK;
    settings.parts.set = PartSet::BRICKS;
    settings.parts.fill = goal.fill;
    settings.colors.palette = "ldraw";
    settings.colors.count = 1;
    settings.parts.effort = Effort::INSTANT;
    settings.grid.upAxis = mesh.upAxis;
    osg::ref_ptr<const BrickModel> model = legolizeOnCpu(*readMesh(mesh), settings);
    if (!model) throw std::runtime_error("'" + mesh.path + "' can't be legolized");
    return model;
}

EquilibriumProgram createProgram(const BrickModel& model)
{
    const std::vector<PartBox> boxes = findPartBoxes(model);
    std::vector<Contact> contacts = findContacts(model);
    int lowest = boxes.front().low.z;
    for (const PartBox& box : boxes)
        lowest = std::min(lowest, box.low.z);
    for (std::uint32_t part = 0; part < boxes.size(); ++part)
        if (boxes[part].low.z == lowest) contacts.push_back({Contact::BASE, part, Contact::TABLE});
    std::vector<std::uint32_t> parts(boxes.size());
    std::iota(parts.begin(), parts.end(), 0u);
    return {boxes, parts, contacts};
}

/** The time that CLP's barrier method, without crossover, takes to minimize the sum of residuals of the same program,
 * with all drags within the capacity. */
double timeClp(const EquilibriumProgram& program)
{
    const auto numRows = static_cast<int>(program.getNumRows());
    std::vector<CoinBigIndex> starts;
    std::vector<int> rows;
    std::vector<double> values;
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> costs;
    const auto addColumn = [&](double least, double most, double cost)
    {
        starts.push_back(static_cast<CoinBigIndex>(values.size()));
        low.push_back(least);
        high.push_back(most);
        costs.push_back(cost);
    };
    constexpr double UNLIMITED = 1e300;
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(program.getNumForces()));
    for (const EquilibriumProgram::Joint& joint : program.getJoints())
        for (std::size_t force = joint.first; force < joint.end; ++force)
        {
            const EquilibriumProgram::Kind kind = program.getKind(force);
            addColumn(kind == EquilibriumProgram::FREE ? -UNLIMITED : 0.0,
                      kind == EquilibriumProgram::DRAG ? StabilityReport::CAPACITY : UNLIMITED,
                      kind == EquilibriumProgram::FREE ? 0.0 : 1e-6);
            const Wrench& wrench = program.getWrench(force);
            const auto add = [&](std::int32_t body, const Eigen::Vector3d& arm, double sign)
            {
                if (body == EquilibriumProgram::NO_BODY) return;
                const Eigen::Vector3d push = wrench.head<3>();
                const Eigen::Vector3d torque = wrench.tail<3>() + arm.cross(push);
                for (int axis = 0; axis < 3; ++axis)
                    for (const auto& [row, value] : {std::pair(axis, push[axis]), std::pair(3 + axis, torque[axis])})
                        if (value != 0.0)
                        {
                            rows.push_back(6 * body + row);
                            values.push_back(sign * value);
                        }
            };
            add(joint.upper, joint.upperArm, 1.0);
            add(joint.lower, joint.lowerArm, -1.0);
        }
    for (int row = 0; row < numRows; ++row)
        for (const double sign : {1.0, -1.0})
        {
            addColumn(0.0, UNLIMITED, 1.0);
            rows.push_back(row);
            values.push_back(sign);
        }
    starts.push_back(static_cast<CoinBigIndex>(values.size()));
    Clp_Simplex* clp = Clp_newModel();
    Clp_setLogLevel(clp, 0);
    Clp_loadProblem(clp, static_cast<int>(costs.size()), numRows, starts.data(), rows.data(), values.data(), low.data(),
                    high.data(), costs.data(), program.getLoad().data(), program.getLoad().data());
    const osg::Timer_t start = osg::Timer::instance()->tick();
    Clp_initialBarrierNoCrossSolve(clp);
    const double milliseconds = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    Clp_deleteModel(clp);
    return milliseconds;
}

void addFactorizations(const EquilibriumProgram& program, unsigned int numRuns, JsonValue& row)
{
    const FactorizationTimes times = measureFactorizations(program, numRuns);
    row["factorization"]["blocks"] = createSpread(times.blocks);
    row["factorization"]["simplicial"] = createSpread(times.simplicial);
}

JsonValue measure(const MeshSource& mesh, const StabilityGoal& goal, const StabilityCommandOptions& options)
{
    const osg::ref_ptr<const BrickModel> model = lay(mesh, goal);
    const bool isSolid = goal.fill == Fill::SOLID;
    std::vector<double> times;
    std::optional<StabilityReport> report;
    resetPeakMemory();
    for (unsigned int run = 0; run < (isSolid ? 1 : options.numRuns); ++run)
    {
        report = computeStability(*model);
        times.push_back(report->milliseconds);
    }
    const double peakMemory = readPeakMemory();
    const EquilibriumProgram program = createProgram(*model);
    JsonValue row{{"mesh", mesh.name},
                  {"fill", isSolid ? "solid" : "surface"},
                  {"resolution", goal.resolution},
                  {"parts", model->getParts().size()},
                  {"components", report->numComponents},
                  {"forces", program.getNumForces()},
                  {"rows", program.getNumRows()},
                  {"milliseconds", createSpread(times)},
                  {"peakMemory", peakMemory},
                  {"stands", report->stands},
                  {"safe", report->safe},
                  {"margin", report->margin},
                  {"falling", report->falling.size()}};
    if (options.usesClp && model->getParts().size() <= MOST_CLP_PARTS) row["clp"] = timeClp(program);
    if (model->getParts().size() <= MOST_COMPARED_PARTS) addFactorizations(program, options.numRuns, row);
    row["goal"] = goal.milliseconds;
    row["memoryGoal"] = MOST_MEMORY;
    row["reached"] = row["milliseconds"]["median"].toNumber() <= goal.milliseconds && peakMemory <= MOST_MEMORY;
    return row;
}

std::string describeFactorization(const JsonValue& row, const std::string& kind)
{
    return row.contains("factorization") ? fmt::format("{:.1f}", row["factorization"][kind]["median"].toNumber()) : "-";
}

void printRow(const JsonValue& row)
{
    const JsonValue& spread = row["milliseconds"];
    fmt::print("| {} {} {} | {} | {} | {} | {} | {:.0f} ({:.0f} to {:.0f}) | {:.0f} | {} | {} | {} "
               "| {} of {} fall, margin {:.2f} | at most {:.0f} ms, {:.0f} MiB | {} |\n",
               row["mesh"].toText(), row["fill"].toText(), row["resolution"].toInteger(), row["parts"].toInteger(),
               row["components"].toInteger(), row["forces"].toInteger(), row["rows"].toInteger(),
               spread["median"].toNumber(), spread["minimum"].toNumber(), spread["maximum"].toNumber(),
               row["peakMemory"].toNumber(), row.contains("clp") ? fmt::format("{:.0f}", row["clp"].toNumber()) : "-",
               describeFactorization(row, "blocks"), describeFactorization(row, "simplicial"),
               row["falling"].toInteger(), row["parts"].toInteger(), row["margin"].toNumber(), row["goal"].toNumber(),
               row["memoryGoal"].toNumber(), row["reached"].toBoolean() ? "reached" : "MISSED");
}

void runStability(const StabilityCommandOptions& options)
{
    const MeshSource mesh = options.getMesh();
    // The goals are those of the bunny, so that another mesh must be asked for.
    if (options.meshes.empty() && !options.isQuick && !mesh.isFile())
        throw std::runtime_error("there is no '" + options.models +
                                 "/bunny.ply', on which the goals are based; expected the folder of the bunny as "
                                 "--models, or a --mesh");
    std::vector<StabilityGoal> goals{{34, 300.0}, {86, 5000.0}};
    if (options.isQuick) goals = {{10, 300.0}};
    if (options.measuresSolid) goals.push_back({options.isQuick ? 10u : 108u, 60000.0, Fill::SOLID});
    JsonValue document = createDocument("stability");
    for (const StabilityGoal& goal : goals)
    {
        fmt::print(stderr, "computing {} at {}{}\n", mesh.name, goal.resolution,
                   goal.fill == Fill::SOLID ? ", solid" : "");
        document["rows"].append(measure(mesh, goal, options));
    }
    if (!options.jsonFile.empty()) return options.write(document);
    fmt::print(
        "| model | parts | components | forces | rows | ms | peak, MiB | CLP's barrier, ms | one factorization, ms "
        "| by Eigen's SimplicialLLT, ms | result | goal | verdict |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const JsonValue& row : document["rows"].getElements())
        printRow(row);
}

} // namespace

void addStabilityCommand(BenchCommandLine& commands)
{
    BenchCommand command = commands.add("stability", "The time to compute whether models of 700 and 5,000 parts stand");
    const auto options = std::make_shared<StabilityCommandOptions>();
    command.addTexts("--mesh", options->meshes, "The mesh: a file, optionally NAME=FILE and ,up=y (the bunny)", "MESH");
    command.addFolder("--models", options->models, "Folder of bunny.ply (build/models)");
    command.addNumber("--runs", options->numRuns, "Timed runs (5)", 1u, 100u);
    command.addFlag("!--no-clp", options->usesClp, "Skip the comparison with CLP");
    command.addFlag("--solid", options->measuresSolid,
                    "Also a solid model of 20,000 parts, once, which takes minutes and gigabytes");
    command.addFlag("--quick", options->isQuick, "A short run that checks that everything works");
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (a table on standard output)",
                    "FILE");
    command.setRun([options] { runStability(*options); });
}

} // namespace osgLego
