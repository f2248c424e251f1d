#include "BenchEnvironment.h"
#include "BenchMeshes.h"
#include "BenchOptions.h"
#include "Commands.h"
#include "FactorizationTimes.h"
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

struct StabilityCommandOptions : BenchOptions
{
    unsigned int numRuns = 5;
    bool usesClp = true;
};

/** A number of cells along the mesh, and the maximum time in milliseconds for a model of that resolution. */
struct StabilityGoal
{
    unsigned int resolution;
    double milliseconds;
};

osg::ref_ptr<const BrickModel> lay(const MeshSource& mesh, unsigned int resolution)
{
    LegoSettings settings;
    settings.grid.resolution = resolution;
    settings.grid.proportions = Proportions::BRICK;
    settings.parts.set = PartSet::BRICKS;
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

JsonValue measure(const MeshSource& mesh, const StabilityGoal& goal, const StabilityCommandOptions& options)
{
    const osg::ref_ptr<const BrickModel> model = lay(mesh, goal.resolution);
    std::vector<double> times;
    std::optional<StabilityReport> report;
    for (unsigned int run = 0; run < options.numRuns; ++run)
    {
        report = computeStability(*model);
        times.push_back(report->milliseconds);
    }
    const EquilibriumProgram program = createProgram(*model);
    JsonValue row{{"mesh", mesh.name},
                  {"resolution", goal.resolution},
                  {"parts", model->getParts().size()},
                  {"components", report->numComponents},
                  {"forces", program.getNumForces()},
                  {"rows", program.getNumRows()},
                  {"milliseconds", createSpread(times)},
                  {"stands", report->stands},
                  {"safe", report->safe},
                  {"margin", report->margin},
                  {"falling", report->falling.size()}};
    if (options.usesClp && model->getParts().size() <= MOST_CLP_PARTS) row["clp"] = timeClp(program);
    const FactorizationTimes factorizations = measureFactorizations(program, options.numRuns);
    row["factorization"]["blocks"] = createSpread(factorizations.blocks);
    row["factorization"]["simplicial"] = createSpread(factorizations.simplicial);
    row["goal"] = goal.milliseconds;
    row["reached"] = row["milliseconds"]["median"].toNumber() <= goal.milliseconds;
    return row;
}

void printRow(const JsonValue& row)
{
    const JsonValue& spread = row["milliseconds"];
    fmt::print(
        "| {} {} | {} | {} | {} | {} | {:.0f} ({:.0f} to {:.0f}) | {} | {:.1f} | {:.1f} | {} of {} fall, margin {:.2f} "
        "| at most {:.0f} | {} |\n",
        row["mesh"].toText(), row["resolution"].toInteger(), row["parts"].toInteger(), row["components"].toInteger(),
        row["forces"].toInteger(), row["rows"].toInteger(), spread["median"].toNumber(), spread["minimum"].toNumber(),
        spread["maximum"].toNumber(), row.contains("clp") ? fmt::format("{:.0f}", row["clp"].toNumber()) : "-",
        row["factorization"]["blocks"]["median"].toNumber(), row["factorization"]["simplicial"]["median"].toNumber(),
        row["falling"].toInteger(), row["parts"].toInteger(), row["margin"].toNumber(), row["goal"].toNumber(),
        row["reached"].toBoolean() ? "reached" : "MISSED");
}

void runStability(const StabilityCommandOptions& options)
{
    const MeshSource mesh = options.getMesh();
    // The goals are those of the bunny, so that another mesh must be asked for.
    if (options.meshes.empty() && !options.isQuick && !mesh.isFile())
        throw std::runtime_error("there is no '" + options.models +
                                 "/bunny.ply', on which the goals are based; expected the folder of the bunny as "
                                 "--models, or a --mesh");
    std::vector<StabilityGoal> goals{{34, 500.0}, {86, 10000.0}};
    if (options.isQuick) goals = {{10, 500.0}};
    JsonValue document = createDocument("stability");
    for (const StabilityGoal& goal : goals)
    {
        fmt::print(stderr, "computing {} at {}\n", mesh.name, goal.resolution);
        document["rows"].append(measure(mesh, goal, options));
    }
    if (!options.jsonFile.empty()) return options.write(document);
    fmt::print("| model | parts | components | forces | rows | ms | CLP's barrier, ms | one factorization, ms "
               "| by Eigen's SimplicialLLT, ms | result | goal, ms | verdict |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
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
    command.addFlag("--quick", options->isQuick, "A short run that checks that everything works");
    command.addText("--json", options->jsonFile, "Write the figures there as JSON (a table on standard output)",
                    "FILE");
    command.setRun([options] { runStability(*options); });
}

} // namespace osgLego
