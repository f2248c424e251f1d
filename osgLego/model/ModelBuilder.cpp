#include <osgLego/model/ModelBuilder.h>

#include <osgLego/layout/CellFill.h>
#include <osgLego/layout/LayoutFigures.h>
#include <osgLego/layout/LayoutModel.h>
#include <osgLego/model/BuildingColumns.h>
#include <osgLego/model/ConnectionBuilder.h>
#include <osgLego/model/LayoutPieces.h>
#include <osgLego/model/SupportBuilder.h>
#include <osgLego/palette/CieLab.h>
#include <osgLego/palette/ColorDifference.h>
#include <osgLego/search/Layout.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <osg/Timer>

namespace osgLego
{

namespace
{

/** The time since the last call, in milliseconds. */
class Stopwatch
{
public:
    double lap()
    {
        const osg::Timer_t now = osg::Timer::instance()->tick();
        return osg::Timer::instance()->delta_m(std::exchange(_start, now), now);
    }

private:
    osg::Timer_t _start = osg::Timer::instance()->tick();
};

/** Replace the colours of cells by those of a palette, and measure the differences. */
osg::ref_ptr<const BrickModel> recolor(const BrickModel& cells, const PaletteLookup& lookup,
                                       LayoutStatistics& statistics)
{
    const std::span<const PaletteColor> colors = lookup.getPalette()->getColors();
    std::vector<glm::dvec3> places;
    for (const PaletteColor& color : colors)
        places.push_back(toCieLab(color.color));
    std::vector<Brick> bricks = cells.getBricks();
    std::size_t numVisible = 0;
    double sum = 0.0;
    for (Brick& brick : bricks)
    {
        const std::size_t index = lookup.find(brick.color, brick.cell);
        if (brick.openSides != 0)
        {
            const double error = ciede2000(places[index], toCieLab(brick.color));
            sum += error;
            statistics.maximumColorError = std::max(statistics.maximumColorError, error);
            ++numVisible;
        }
        brick.color = colors[index].color;
    }
    if (numVisible > 0) statistics.meanColorError = sum / static_cast<double>(numVisible);
    return BrickModel::createComplete(cells.getGrid(), std::move(bricks));
}

std::string describeLeak(Fill fill)
{
    const std::string name = fill == Fill::SOLID ? "solid" : "shell";
    return "the model has no interior, so fill=" + name +
           " adds no cells; expected a surface without holes wider than a cell";
}

std::vector<Brick> selectCovered(const FilledCells& cells)
{
    std::vector<Brick> covered;
    for (std::size_t index = 0; index < cells.bricks.size(); ++index)
        if (!cells.isInterior[index]) covered.push_back(cells.bricks[index]);
    return covered;
}

/** Parts, and the cells that they cover. */
struct Layout
{
    LayoutProblem problem;
    LaidParts parts;
};

/** The pieces of a layout apart from the largest. */
std::vector<LoosePiece> listLoosePieces(const LaidParts& parts, const BrickGrid& grid)
{
    const LayoutPieces pieces(parts);
    std::vector<LoosePiece> loose;
    for (std::uint32_t index = 1; index < pieces.getCount(); ++index)
    {
        glm::ivec3 lower = pieces.getCells(index).front();
        glm::ivec3 upper = lower;
        for (const glm::ivec3& cell : pieces.getCells(index))
        {
            lower = glm::min(lower, cell);
            upper = glm::max(upper, cell);
        }
        loose.push_back({pieces.countParts(index), toGridCell(lower, grid), toGridCell(upper, grid)});
    }
    return loose;
}

struct Connected
{
    JoinedLayout layout;
    ConnectionStatistics statistics;

    /** Fewer pieces come first, then fewer parts, since both are goals of Effort::BEST, then fewer changes. */
    bool isBetterThan(const Connected& other) const
    {
        const auto rank = [](const Connected& some)
        {
            return std::tuple(some.statistics.numPieces, some.layout.parts.size(),
                              some.statistics.numAddedCells + some.statistics.numRecolored);
        };
        return rank(*this) < rank(other);
    }
};

/** Join the pieces of a layout. @return nothing if it was cancelled. */
std::optional<Connected> connect(const LayoutOptions& options, const RecoloringCosts& costs, Layout layout)
{
    ConnectionBuilder builder(options, costs);
    Connected connected{{std::move(layout.problem), std::move(layout.parts), {}}, {}};
    if (!builder.build(connected.layout)) return std::nullopt;
    connected.statistics = builder.getStatistics();
    return connected;
}

/** Join the pieces of a layout of Effort::BEST. Those of a layout of normal effort are joined, too, since the pieces of
 * either may be easier to join. @return the better one; nothing if it was cancelled. */
std::optional<Connected> connectBest(const LayoutOptions& options, const RecoloringCosts& costs, const Layout& layout,
                                     const LaidParts& previous)
{
    std::optional<Connected> connected = connect(options, costs, layout);
    if (!connected || connected->statistics.numPiecesBefore <= 1) return connected;
    LayoutOptions silent = options;
    silent.progress = nullptr; // the same pieces were joined already
    LayoutOptions normal = silent;
    normal.effort = Effort::NORMAL;
    Layout other{layout.problem, layOut(layout.problem, normal, previous)};
    if (other.parts.empty()) return std::nullopt;
    // Parts around the joins are laid again with all effort.
    std::optional<Connected> otherConnected = connect(silent, costs, std::move(other));
    return !otherConnected || otherConnected->isBetterThan(*connected) ? std::move(otherConnected)
                                                                       : std::move(connected);
}

/** Join the pieces of a layout. @param previous from which it was laid. @return false if it was cancelled. */
bool connect(const LayoutOptions& options, const RecoloringCosts& costs, const BrickGrid& grid,
             const LaidParts& previous, Layout& layout, LayoutStatistics& statistics)
{
    Stopwatch stopwatch;
    std::optional<Connected> connected = options.effort == Effort::BEST ? connectBest(options, costs, layout, previous)
                                                                        : connect(options, costs, std::move(layout));
    if (!connected) return false;
    layout = {std::move(connected->layout.problem), std::move(connected->layout.parts)};
    statistics.connection = std::move(connected->statistics);
    statistics.connection->loose = listLoosePieces(layout.parts, grid);
    statistics.connection->milliseconds = stopwatch.lap();
    return true;
}

/** A function that reports progress as a part of other work; empty if that is.
 * @param report is kept as a reference. @param first and last the fractions of the other work before and after this
 * part. */
std::function<void(double)> reportPart(const std::function<void(double)>& report, double first, double last)
{
    if (!report) return {};
    return [&report, first, last](double fraction) { report(first + (last - first) * fraction); };
}

/** A function that leaves out reports of no progress; empty if `report` is. */
std::function<void(double)> reportIncreases(std::function<void(double)> report)
{
    if (!report) return {};
    return [report = std::move(report), last = -1.0](double fraction) mutable
    {
        if (fraction > last) report(last = fraction);
    };
}

/** Change a layout whose pieces were joined so that it stands, and is easy to build. @return false if it was cancelled.
 */
bool support(const LayoutOptions& options, const BuildingColumns::CreateModel& createModel, const BrickGrid& grid,
             Layout& layout, LayoutStatistics& statistics)
{
    constexpr double STANDING = 0.4; // the fraction of progress after which the model stands
    SupportedLayout supported{std::move(layout.problem), std::move(layout.parts)};
    LayoutOptions standing = options;
    standing.progress = reportPart(options.progress, 0.0, STANDING);
    if (!SupportBuilder(standing).build(supported)) return false;
    const std::function<void(double)> progress = reportPart(options.progress, STANDING, 1.0);
    if (supported.stands && !BuildingColumns(supported, createModel, options.isCancelled, progress).run()) return false;
    layout.problem = std::move(supported.problem);
    layout.parts = std::move(supported.parts);
    statistics.support = {.stands = supported.stands,
                          .isLaidAgain = supported.isLaidAgain,
                          .numHiddenCells = supported.numHiddenCells,
                          .numColumns = supported.columns.size(),
                          .numColumnParts = supported.numColumnParts,
                          .numPropped = supported.numPropped,
                          .numBuildingColumns = supported.numBuildingColumns,
                          .largestSubmodel = supported.largestSubmodel,
                          .deepestSubmodel = supported.deepestSubmodel,
                          .numFallingSteps = supported.numFallingSteps};
    const std::size_t numPieces = LayoutPieces(layout.parts).getCount();
    statistics.connection->isSupported = numPieces < statistics.connection->numPieces;
    statistics.connection->numPieces = numPieces;
    statistics.connection->loose = listLoosePieces(layout.parts, grid);
    return true;
}

/** The parts of an earlier layout, where they are in a grid. A grid that is fitted to the source moves with it, and its
 * parts, too; a grid of a lattice begins elsewhere when the extent of the source changes. */
LaidParts selectPrevious(const PreviousLayout& previous, const BrickGrid& grid)
{
    if (!previous.settings.grid.cellPitch) return previous.parts;
    return moveParts(previous.parts, previous.grid, grid);
}

/** Width, depth and height of the cells of a layout, in millimetres. */
glm::dvec3 measureSize(const LayoutProblem& problem)
{
    constexpr double PITCH = 8.0;
    constexpr double BRICK_HEIGHT = 9.6;
    constexpr double PLATE_HEIGHT = 3.2;
    if (problem.cells.empty()) return glm::dvec3(0.0);
    glm::ivec3 lower = problem.size;
    glm::ivec3 upper(0);
    for (const LayoutCell& cell : problem.cells)
    {
        const glm::ivec3 place(cell.place[0], cell.place[1], cell.place[2]);
        lower = glm::min(lower, place);
        upper = glm::max(upper, place + 1);
    }
    return glm::dvec3(upper - lower) * glm::dvec3(PITCH, PITCH, problem.isOfPlates ? PLATE_HEIGHT : BRICK_HEIGHT);
}

/** Add the figures of a layout to its statistics. */
LayoutStatistics measure(const Layout& layout, LayoutStatistics statistics)
{
    Stopwatch stopwatch;
    const LayoutFigures figures = computeLayoutFigures(layout.problem, layout.parts);
    statistics.numCells = figures.cells;
    statistics.numParts = figures.parts;
    statistics.size = measureSize(layout.problem);
    statistics.numComponents = figures.components;
    statistics.numComponentsPossible = figures.componentsPossible;
    statistics.numArticulationParts = figures.articulationParts;
    statistics.numFloating = figures.floating;
    statistics.stackedSeams = figures.getStackedSeams();
    statistics.stackedLength = figures.stackedLength;
    statistics.numColors = figures.colors;
    statistics.numUnavailable = figures.unavailable;
    statistics.figures = stopwatch.lap();
    return statistics;
}

} // namespace

ModelBuilder::ModelBuilder(const LegoSettings& settings, const PaletteLookup& lookup) :
    _settings(settings), _lookup(lookup)
{
}

osg::ref_ptr<const BrickModel> ModelBuilder::build(const BrickModel& cells)
{
    _error.clear();
    _warning.clear();
    _measureLayout = nullptr;
    LayoutStatistics statistics;
    Stopwatch stopwatch;
    osg::ref_ptr<const BrickModel> colored = &cells;
    if (_lookup.hasPalette()) colored = recolor(cells, _lookup, statistics);
    statistics.palette = stopwatch.lap();
    if (!_settings.needsCpu()) return colored;

    FilledCells filled;
    if (isCancelled() || !fillCells(*colored, _settings.parts.fill, _settings.parts.shell, filled, _error))
        return nullptr;
    if (_settings.parts.fill != Fill::SURFACE && filled.numInterior == 0 && !cells.getBricks().empty())
        _warning = describeLeak(_settings.parts.fill);
    statistics.fill = stopwatch.lap();
    if (_settings.parts.set == PartSet::NONE) return BrickModel::create(cells.getGrid(), std::move(filled.bricks));
    return lay(filled, cells, statistics);
}

/** A function that reports which fraction of a stage is done; empty without anyone to report to. */
std::function<void(double)> ModelBuilder::reportStage(LegoProgress::Stage stage) const
{
    if (!_progress) return {};
    return [this, stage](double fraction) { _progress({stage, static_cast<float>(fraction)}); };
}

osg::ref_ptr<const BrickModel> ModelBuilder::lay(const FilledCells& cells, const BrickModel& surface,
                                                 LayoutStatistics& statistics)
{
    const BrickGrid& grid = surface.getGrid();
    Stopwatch stopwatch;
    std::vector<PaletteColor> colors = collectColors(cells);
    if (const Palette* palette = _lookup.getPalette())
        colors.assign(palette->getColors().begin(), palette->getColors().end());
    const auto layout = std::make_shared<Layout>();
    layout->problem = createProblem(cells, grid, colors);
    LaidParts previous;
    if (_previous && _previous->settings.givesSameBricks(_settings) && _previous->colors == colors)
        previous = selectPrevious(*_previous, grid);
    if (isCancelled()) return nullptr;
    LayoutOptions options{.effort = _settings.parts.effort,
                          .isGreedy = _isGreedy,
                          .seed = _settings.parts.seed,
                          .isCancelled = _isCancelled,
                          .progress = reportStage(LegoProgress::Stage::PARTS)};
    layout->parts = layOut(layout->problem, options, previous);
    if ((layout->parts.empty() && !layout->problem.cells.empty()) || isCancelled()) return nullptr;
    statistics.layout = stopwatch.lap();
    options.progress = reportStage(LegoProgress::Stage::CONNECTION);
    if ((_settings.parts.connect || _settings.parts.support) &&
        !connect(options, RecoloringCosts(surface, colors), grid, previous, *layout, statistics))
        return nullptr;
    stopwatch.lap();
    if (_settings.parts.support)
    {
        options.progress = reportIncreases(reportStage(LegoProgress::Stage::SUPPORT));
        if (options.progress) options.progress(0.0);
        const auto createBare = [&](const LaidParts& parts) { return createModel(parts, grid, colors); };
        if (!support(options, createBare, grid, *layout, statistics)) return nullptr;
        statistics.support->milliseconds = stopwatch.lap();
    }
    statistics.numInterior = cells.numInterior;
    osg::ref_ptr<const BrickModel> model = createModel(layout->parts, grid, colors, selectCovered(cells));
    _measureLayout = [layout, statistics] { return measure(*layout, statistics); };
    if (_previous)
    {
        _previous->settings = _settings;
        _previous->grid = grid;
        _previous->parts = layout->parts;
        _previous->colors = std::move(colors);
    }
    return model;
}

} // namespace osgLego
