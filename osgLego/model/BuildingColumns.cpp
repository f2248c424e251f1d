#include <osgLego/model/BuildingColumns.h>

#include <osgLego/building/PlanBuilder.h>
#include <osgLego/layout/LayoutModel.h>
#include <osgLego/model/CellExposure.h>
#include <osgLego/model/LayerColumns.h>
#include <osgLego/model/LayoutPieces.h>
#include <osgLego/model/LayoutStanding.h>
#include <osgLego/model/StepColumns.h>
#include <osgLego/model/SupportColumns.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace osgLego
{

namespace
{

/** The limits of an attempt of LayerColumns. */
struct ColumnLimits
{
    std::size_t mostHanging;
    double mostAdded;
};

// In the order of attempts. If only small groups are left out, there are more columns.
constexpr std::array<ColumnLimits, 6> ATTEMPTS{{{60, 0.1}, {150, 0.1}, {30, 0.1}, {10, 0.1}, {60, 0.2}, {10, 0.2}}};

// The groups of further attempts with the greatest share of cells, each followed by columns below steps. They start
// without columns, and so choose other places than attempts that go on from those of a smaller share.
constexpr std::array<std::size_t, 3> HANGING_ANEW{10, 30, 150};

// The greatest share of cells of columns, and the rounds in which StepColumns adds some: each changes the steps.
constexpr double MOST_ADDED = 0.2;
constexpr int MOST_ROUNDS = 3;
// The most attempts to do without some columns, and the least for large models: each may take a plan.
constexpr std::size_t MOST_PRUNINGS = 20;
constexpr std::size_t LEAST_PRUNINGS = 6;
constexpr std::size_t MOST_PRUNED_PARTS = 6000; // over all attempts

// The fractions of progress after the first plan, after columns below layers, and after those below steps.
constexpr double PLANNED = 0.2;
constexpr double BELOW_LAYERS = 0.6;
constexpr double BELOW_STEPS = 0.8;

/** The largest number of cells of a layout with columns. @param mostAdded their share. */
std::size_t getMostCells(const SupportedLayout& layout, double mostAdded)
{
    return static_cast<std::size_t>((1.0 + mostAdded) * static_cast<double>(layout.problem.cells.size()));
}

bool keepsSubmodelLimits(const BuildingPlan& plan)
{
    return plan.getLargestSubmodel() <= BuildingPlan::MOST_SUBMODEL_PARTS &&
           plan.getDeepestSubmodel() <= BuildingPlan::DEEPEST_SUBMODEL;
}

/** Whether submodels of a plan are no larger, and nested no deeper, than those of another one or than the limits. */
bool hasSubmodelsAsEasy(const BuildingPlan& plan, const BuildingPlan& other)
{
    return plan.getLargestSubmodel() <= std::max(BuildingPlan::MOST_SUBMODEL_PARTS, other.getLargestSubmodel()) &&
           plan.getDeepestSubmodel() <= std::max(BuildingPlan::DEEPEST_SUBMODEL, other.getDeepestSubmodel());
}

/** The most steps after which parts may fall if a plan is as easy as another one. */
std::size_t getMostFalling(const BuildingPlan& other)
{
    return std::max(BuildingPlan::MOST_FALLING_STEPS, other.getNumFalling());
}

/** Whether a plan exceeds no limit by more than another one. */
bool isAsEasy(const BuildingPlan& plan, const BuildingPlan& other)
{
    return hasSubmodelsAsEasy(plan, other) && plan.getNumFalling() <= getMostFalling(other);
}

/** Columns in the order of how much of them is seen, most first. */
std::vector<SupportColumn> sortByExposure(std::span<const SupportColumn> columns, const LayoutProblem& problem)
{
    const CellExposure exposure(problem);
    std::vector<std::pair<double, SupportColumn>> exposed;
    exposed.reserve(columns.size());
    for (const SupportColumn& column : columns)
        exposed.emplace_back(sumExposure(column, exposure), column);
    std::stable_sort(exposed.begin(), exposed.end(),
                     [](const auto& column, const auto& other) { return column.first > other.first; });
    std::vector<SupportColumn> sorted;
    sorted.reserve(columns.size());
    for (const auto& [sum, column] : exposed)
        sorted.push_back(column);
    return sorted;
}

/** Whether other columns of a layout stand on some of its columns. */
bool carryOthers(std::span<const SupportColumn> columns, const SupportedLayout& layout)
{
    return std::any_of(layout.columns.begin(), layout.columns.end(),
                       [columns](const SupportColumn& other)
                       {
                           const bool isOther = std::find(columns.begin(), columns.end(), other) == columns.end();
                           return isOther &&
                                  std::any_of(columns.begin(), columns.end(),
                                              [&other](const auto& column) { return other.standsOn(column); });
                       });
}

} // namespace

bool BuildingColumns::run()
{
    if (_layout.parts.size() > MOST_PARTS) return true;
    if (!plan(_layout, PlanBuilder::ANY, _planned)) return false;
    const SupportedLayout original = _layout;
    const Planned originalPlanned = _planned;
    report(PLANNED);
    if (!addBelowLayers(original)) return false;
    report(BELOW_LAYERS);
    const std::size_t mostCells = getMostCells(original, MOST_ADDED);
    if (!addBelowSteps(mostCells)) return false;
    double done = BELOW_LAYERS;
    for (const std::size_t mostHanging : HANGING_ANEW)
    {
        if (_planned.plan->keepsLimits()) break;
        const SupportedLayout best = std::exchange(_layout, original);
        const Planned bestPlanned = std::exchange(_planned, originalPlanned);
        if (!addAnew(mostHanging, mostCells)) return false;
        if (!_planned.plan->exceedsLimitsLessThan(*bestPlanned.plan))
        {
            _layout = best;
            _planned = bestPlanned;
        }
        report(done += (BELOW_STEPS - BELOW_LAYERS) / static_cast<double>(HANGING_ANEW.size()));
    }
    report(BELOW_STEPS);
    if (!removeUnneeded(original.columns.size())) return false;
    _layout.numBuildingColumns = _layout.columns.size() - original.columns.size();
    _layout.largestSubmodel = _planned.plan->getLargestSubmodel();
    _layout.deepestSubmodel = _planned.plan->getDeepestSubmodel();
    _layout.numFallingSteps = _planned.plan->getNumFalling();
    return true;
}

/** While submodels are too large or nested too deep, add columns where parts fall when a layer is complete, if that
 * makes the model easier to build.
 * @param original the layout without these columns. @return false if it was cancelled. */
bool BuildingColumns::addBelowLayers(const SupportedLayout& original)
{
    std::map<std::size_t, LayerColumns> attempts; // by the parts of groups that are left out
    double done = PLANNED;
    for (const ColumnLimits& limits : ATTEMPTS)
    {
        if (keepsSubmodelLimits(*_planned.plan)) return true;
        LayerColumns& columns =
            attempts.try_emplace(limits.mostHanging, original, limits.mostHanging, _isCancelled).first->second;
        if (!add(columns, getMostCells(original, limits.mostAdded))) return false;
        report(done += (BELOW_LAYERS - PLANNED) / static_cast<double>(ATTEMPTS.size()));
    }
    return true;
}

/** Replace the layout by one with more columns below layers, if that is easier to build.
 * @return false if it was cancelled. */
bool BuildingColumns::add(LayerColumns& columns, std::size_t mostCells)
{
    const std::size_t numColumns = columns.getLayout().columns.size();
    const bool isDone = columns.run(mostCells);
    if (isCancelled()) return false;
    const bool hasChanged = columns.getLayout().columns.size() > numColumns;
    return !isDone || !hasChanged || replaceIfBetter(columns.getLayout());
}

/** Plan a layout, if parts fall after at most some steps. @return false if it was cancelled. */
bool BuildingColumns::plan(const SupportedLayout& layout, std::size_t mostFalling, Planned& planned) const
{
    PlanningOptions options;
    options.isCancelled = _isCancelled;
    if (!_planned.plan) options.progress = [this](double fraction) { report(PLANNED * fraction); };
    planned.model = _createModel(layout.parts);
    planned.plan = PlanBuilder(*planned.model, options).build(mostFalling);
    // Without a limit, there is only no plan if it was cancelled.
    return planned.plan || (mostFalling != PlanBuilder::ANY && !isCancelled());
}

/** Add columns below layers, and then below steps, if that makes the model easier to build.
 * @param mostHanging see LayerColumns. @return false if it was cancelled. */
bool BuildingColumns::addAnew(std::size_t mostHanging, std::size_t mostCells)
{
    LayerColumns columns(_layout, mostHanging, _isCancelled);
    const std::size_t numColumns = _layout.columns.size();
    if (!add(columns, mostCells)) return false;
    return _layout.columns.size() == numColumns || addBelowSteps(mostCells);
}

/** While too many parts fall after steps, add columns there, if that makes the model easier to build.
 * @return false if it was cancelled. */
bool BuildingColumns::addBelowSteps(std::size_t mostCells)
{
    for (int round = 0; round < MOST_ROUNDS && _planned.plan->getNumFalling() > BuildingPlan::MOST_FALLING_STEPS;
         ++round)
    {
        const std::size_t numColumns = _layout.columns.size();
        if (!addBelowFallingSteps(mostCells)) return false;
        if (_layout.columns.size() == numColumns) break;
    }
    return true;
}

/** @return false if it was cancelled. */
bool BuildingColumns::addBelowFallingSteps(std::size_t mostCells)
{
    const BuildingPlan& plan = *_planned.plan;
    std::vector<std::size_t> numsPlaced;
    for (std::size_t step = 0; step < plan.getSteps().size(); ++step)
        if (!plan.getSteps()[step].stands) numsPlaced.push_back(plan.getNumPlaced(step));
    StepColumns columns(_layout, findRanks(), _isCancelled);
    if (!columns.run(numsPlaced, mostCells)) return false;
    return columns.getLayout().columns.size() == _layout.columns.size() || replaceIfBetter(columns.getLayout());
}

/** The ranks of the parts of the layout in the plan. */
std::vector<std::uint32_t> BuildingColumns::findRanks() const
{
    std::vector<std::uint32_t> ranks;
    for (const std::uint32_t index : findModelIndices(_layout.parts, *_planned.model))
        ranks.push_back(_planned.plan->getRanks()[index]);
    return ranks;
}

/** Replace the layout by one with other columns, if that is easier to build. @return false if it was cancelled. */
bool BuildingColumns::replaceIfBetter(const SupportedLayout& other)
{
    if (hasMorePieces(other)) return true;
    Planned changed;
    if (!findPlanIfStanding(other, PlanBuilder::ANY, changed)) return false;
    if (!changed.plan || !changed.plan->exceedsLimitsLessThan(*_planned.plan)) return true;
    _layout = other;
    _planned = changed;
    return true;
}

bool BuildingColumns::hasMorePieces(const SupportedLayout& other) const
{
    return LayoutPieces(other.parts).getCount() > LayoutPieces(_layout.parts).getCount();
}

/** Plan another layout, if it stands. @return false if it was cancelled. */
bool BuildingColumns::findPlanIfStanding(const SupportedLayout& layout, std::size_t mostFalling, Planned& planned) const
{
    const std::optional<StabilityReport> standing = computeStanding(layout.problem, layout.parts, _isCancelled);
    if (!standing) return false;
    return !standing->stands || plan(layout, mostFalling, planned);
}

/** Remove columns that make the model no easier to build, those that are seen most first: halves of all, quarters, and
 * single ones.
 * @param numNeeded those without which it falls, which come first. @return false if it was cancelled. */
bool BuildingColumns::removeUnneeded(std::size_t numNeeded)
{
    std::vector<SupportColumn> columns =
        sortByExposure(std::span<const SupportColumn>(_layout.columns).subspan(numNeeded), _layout.problem);
    const std::size_t half = (columns.size() + 1) / 2;
    const std::size_t mostAttempts =
        std::clamp(MOST_PRUNED_PARTS / _layout.parts.size(), LEAST_PRUNINGS, MOST_PRUNINGS);
    std::size_t numAttempts = 0;
    for (const std::size_t size : std::set<std::size_t, std::greater<>>{half, (half + 1) / 2, 1})
        for (std::size_t first = 0; first < columns.size() && numAttempts < mostAttempts; ++numAttempts)
        {
            const std::size_t count = std::min(size, columns.size() - first);
            if (count == columns.size()) break; // without any, the model was harder to build
            bool isRemoved = false;
            if (!removeIfUnneeded(std::span(columns).subspan(first, count), isRemoved)) return false;
            const auto begin = columns.begin() + static_cast<std::ptrdiff_t>(first);
            if (isRemoved)
                columns.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
            else
                first += count;
            report(BELOW_STEPS +
                   (1.0 - BELOW_STEPS) * static_cast<double>(numAttempts + 1) / static_cast<double>(mostAttempts));
        }
    return true;
}

/** Remove columns together, if that makes the model no harder to build. @return false if it was cancelled. */
bool BuildingColumns::removeIfUnneeded(std::span<const SupportColumn> columns, bool& isRemoved)
{
    if (carryOthers(columns, _layout)) return true;
    const SupportedLayout other = removeColumns(_layout, columns);
    if (hasMorePieces(other)) return true;
    // Plans without checks of stability, which take far longer, seldom have larger submodels.
    if (!isAsEasyWithoutChecks(other)) return !isCancelled();
    Planned changed;
    if (!findPlanIfStanding(other, getMostFalling(*_planned.plan), changed)) return false;
    if (!changed.plan || !isAsEasy(*changed.plan, *_planned.plan)) return true;
    _layout = other;
    _planned = changed;
    isRemoved = true;
    return true;
}

/** Whether submodels are as easy if parts need not stand after the steps. */
bool BuildingColumns::isAsEasyWithoutChecks(const SupportedLayout& layout) const
{
    PlanningOptions options;
    options.isCancelled = _isCancelled;
    options.checksStability = false;
    const osg::ref_ptr<const BrickModel> model = _createModel(layout.parts);
    const osg::ref_ptr<const BuildingPlan> plan = PlanBuilder(*model, options).build();
    return plan && hasSubmodelsAsEasy(*plan, *_planned.plan);
}

void BuildingColumns::report(double fraction) const
{
    if (_progress) _progress(fraction);
}

} // namespace osgLego
