#include "LayoutCase.h"

#include "Spread.h"

#include <osgLego/CpuLegolizer.h>
#include <osgLego/layout/LayoutCheck.h>
#include <osgLego/layout/LayoutFigures.h>
#include <osgLego/layout/LayoutModel.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include <osg/Timer>

namespace osgLego
{

namespace
{

// The bounds of larger models would take hours.
constexpr std::size_t MAXIMUM_BOUND_CELLS = 100000;
constexpr std::size_t NUM_SAMPLED_LAYERS = 12;

/** Cells, and the colours that their parts may have. */
struct CaseCells
{
    osg::ref_ptr<const BrickModel> model;
    std::vector<PaletteColor> colors;
};

osg::ref_ptr<const BrickModel> paintAll(const BrickModel& model, const PaletteColor& color)
{
    std::vector<Brick> bricks = model.getBricks();
    for (Brick& brick : bricks)
        brick.color = color.color;
    return BrickModel::createComplete(model.getGrid(), std::move(bricks));
}

CaseCells findCells(const LayoutCase& layoutCase)
{
    LegoSettings settings = layoutCase.settings;
    settings.grid.upAxis = layoutCase.mesh.upAxis;
    settings.parts.fill = Fill::SURFACE;
    CaseCells cells;
    cells.model = legolizeOnCpu(*readMesh(layoutCase.mesh), settings);
    if (!cells.model) throw std::runtime_error("'" + layoutCase.mesh.path + "' can't be legolized");
    if (!settings.colors.palette)
    {
        cells.colors.resize(1);
        cells.model = paintAll(*cells.model, cells.colors.front());
        return cells;
    }
    std::string error;
    const osg::ref_ptr<const Palette> palette = Palette::read(*settings.colors.palette, error);
    if (!palette) throw std::runtime_error(error);
    cells.colors.assign(palette->getColors().begin(), palette->getColors().end());
    return cells;
}

/** The steps from covered cells to a model of parts. */
class LayoutRun
{
public:
    LayoutRun(const CaseCells& cells, const LegoSettings& settings)
    {
        const osg::Timer_t start = osg::Timer::instance()->tick();
        FilledCells filled;
        std::string error;
        if (!fillCells(*cells.model, settings.parts.fill, settings.parts.shell, filled, error))
            throw std::runtime_error(error);
        problem = createProblem(filled, cells.model->getGrid(), cells.colors);
        parts = layOut(problem, {.effort = settings.parts.effort, .seed = settings.parts.seed});
        model = createModel(parts, cells.model->getGrid(), cells.colors);
        milliseconds = osg::Timer::instance()->delta_m(start, osg::Timer::instance()->tick());
    }

    LayoutProblem problem;
    LaidParts parts;
    osg::ref_ptr<const BrickModel> model;
    double milliseconds = 0.0;
};

/** All layers with cells, or some of them, evenly spread over a large model. */
std::vector<int> chooseLayers(const LayoutProblem& problem)
{
    std::vector<int> layers;
    for (const LayoutCell& cell : problem.cells)
        if (layers.empty() || layers.back() != cell.place[2]) layers.push_back(cell.place[2]);
    if (problem.cells.size() <= MAXIMUM_BOUND_CELLS || layers.size() <= NUM_SAMPLED_LAYERS) return layers;
    std::vector<int> sample;
    for (std::size_t index = 0; index < NUM_SAMPLED_LAYERS; ++index)
        sample.push_back(layers[(2 * index + 1) * layers.size() / (2 * NUM_SAMPLED_LAYERS)]);
    return sample;
}

void addBound(JsonValue& row, const LayoutRun& run, const std::vector<LayerBound>& bounds, std::size_t numLayers)
{
    std::size_t sum = 0;
    std::size_t numParts = 0;
    for (const LayerBound& bound : bounds)
    {
        sum += bound.parts;
        numParts += static_cast<std::size_t>(std::count_if(
            run.parts.begin(), run.parts.end(), [&bound](const LaidPart& part) { return part.place[2] == bound.z; }));
    }
    const auto isOptimum = [](const LayerBound& bound) { return bound.isOptimum; };
    row["bound"] = {{"parts", sum},
                    {"ofParts", numParts},
                    {"layers", bounds.size()},
                    {"allLayers", numLayers},
                    {"optimalLayers", std::count_if(bounds.begin(), bounds.end(), isOptimum)}};
    row["ratio"] = static_cast<double>(numParts) / static_cast<double>(sum);
}

/** The number of parts of a layout of plates alone. */
std::size_t countPlates(LayoutProblem problem, Effort effort)
{
    problem.isOfPlates = false;
    for (LayoutColor& color : problem.colors)
        color.bricks = color.plates;
    return layOut(problem, {.effort = effort}).size();
}

JsonValue createRow(const LayoutCase& layoutCase, const LayoutRun& run)
{
    const LayoutFigures figures = computeLayoutFigures(run.problem, run.parts);
    return {{"figure", layoutCase.figure},
            {"mesh", layoutCase.mesh.name},
            {"resolution", layoutCase.settings.grid.resolution},
            {"cells", figures.cells},
            {"parts", figures.parts},
            {"stacked", figures.getStackedSeams()},
            {"stackedAtBorders", figures.getStackedBorders()},
            {"stackedLength", figures.stackedLength},
            {"components", figures.components},
            {"componentsPossible", figures.componentsPossible},
            {"articulation", static_cast<double>(figures.articulationParts) / static_cast<double>(figures.parts)},
            {"floating", figures.floating},
            {"colors", figures.colors},
            {"unavailable", figures.unavailable}};
}

void addGoal(JsonValue& row, const std::string& what, double figure, const std::optional<double>& goal)
{
    if (!goal) return;
    row["goals"].append({{"what", what}, {"figure", figure}, {"goal", *goal}, {"reached", figure <= *goal}});
}

/** The number of a member, or 0 if the row has none. */
double findNumber(const JsonValue& row, const char* name)
{
    return row.contains(name) ? row[name].toNumber() : 0.0;
}

void addGoals(JsonValue& row, const LayoutGoals& goals)
{
    addGoal(row, "parts / bound", findNumber(row, "ratio"), goals.ratio);
    addGoal(row, "parts / plates alone", findNumber(row, "ofPlates"), goals.ofPlates);
    addGoal(row, "stacked", row["stacked"].toNumber(), goals.stacked);
    addGoal(row, "articulation", row["articulation"].toNumber(), goals.articulation);
    addGoal(row, "milliseconds", row["milliseconds"]["median"].toNumber(), goals.milliseconds);
    addGoal(row, "components", row["components"].toNumber(), row["componentsPossible"].toNumber());
}

} // namespace

JsonValue measureLayout(const LayoutCase& layoutCase, const LayoutRuns& runs, BoundCache& bounds)
{
    const CaseCells cells = findCells(layoutCase);
    std::vector<double> times;
    LayoutRun run(cells, layoutCase.settings);
    times.push_back(run.milliseconds);
    while (times.size() < runs.numRuns)
        times.push_back(LayoutRun(cells, layoutCase.settings).milliseconds);
    if (const std::string error = findLayoutError(run.problem, run.parts); !error.empty())
        throw std::runtime_error("the layout of '" + layoutCase.mesh.name + "' is wrong: " + error);
    JsonValue row = createRow(layoutCase, run);
    row["milliseconds"] = createSpread(times);
    if (run.problem.isOfPlates)
        row["ofPlates"] = static_cast<double>(run.parts.size()) /
                          static_cast<double>(countPlates(run.problem, layoutCase.settings.parts.effort));
    else if (layoutCase.goals.ratio)
    {
        std::set<int> layers;
        for (const LayoutCell& cell : run.problem.cells)
            layers.insert(cell.place[2]);
        addBound(row, run, bounds.getBounds(run.problem, chooseLayers(run.problem), runs.boundSeconds), layers.size());
    }
    addGoals(row, layoutCase.goals);
    return row;
}

} // namespace osgLego
