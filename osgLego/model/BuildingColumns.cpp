#include <osgLego/model/BuildingColumns.h>

#include <osgLego/BuildingPlanner.h>
#include <osgLego/layout/LayoutModel.h>
#include <osgLego/model/LayerColumns.h>
#include <osgLego/model/LayoutPieces.h>
#include <osgLego/model/LayoutStanding.h>
#include <osgLego/model/StepColumns.h>

#include <array>
#include <map>
#include <optional>
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

// The greatest share of cells of columns, and the rounds in which StepColumns adds some: each changes the steps.
constexpr double MOST_ADDED = 0.2;
constexpr int MOST_ROUNDS = 3;

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

} // namespace

bool BuildingColumns::run()
{
    if (_layout.parts.size() > MOST_PARTS) return true;
    if (!plan(_layout, _planned)) return false;
    const SupportedLayout original = _layout;
    if (!addBelowLayers(original)) return false;
    for (int round = 0; round < MOST_ROUNDS && _planned.plan->getNumFalling() > BuildingPlan::MOST_FALLING_STEPS;
         ++round)
    {
        const std::size_t numColumns = _layout.numColumns;
        if (!addBelowSteps(getMostCells(original, MOST_ADDED))) return false;
        if (_layout.numColumns == numColumns) break;
    }
    _layout.numBuildingColumns = _layout.numColumns - original.numColumns;
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
    for (const ColumnLimits& limits : ATTEMPTS)
    {
        if (keepsSubmodelLimits(*_planned.plan)) return true;
        LayerColumns& columns =
            attempts.try_emplace(limits.mostHanging, original, limits.mostHanging, _isCancelled).first->second;
        const std::size_t numColumns = columns.getLayout().numColumns;
        const bool isDone = columns.run(getMostCells(original, limits.mostAdded));
        if (isCancelled()) return false;
        const bool hasChanged = columns.getLayout().numColumns > numColumns;
        if (isDone && hasChanged && !replaceIfBetter(columns.getLayout())) return false;
    }
    return true;
}

/** @return false if it was cancelled. */
bool BuildingColumns::plan(const SupportedLayout& layout, Planned& planned) const
{
    PlanningOptions options;
    options.isCancelled = _isCancelled;
    planned.model = _createModel(layout.parts);
    planned.plan = planBuilding(*planned.model, options);
    return planned.plan.valid();
}

/** Add columns where parts fall after steps of the model, if that makes it easier to build.
 * @return false if it was cancelled. */
bool BuildingColumns::addBelowSteps(std::size_t mostCells)
{
    const BuildingPlan& plan = *_planned.plan;
    std::vector<std::size_t> numsPlaced;
    for (std::size_t step = 0; step < plan.getSteps().size(); ++step)
        if (!plan.getSteps()[step].stands) numsPlaced.push_back(plan.getNumPlaced(step));
    StepColumns columns(_layout, findRanks(), _isCancelled);
    if (!columns.run(numsPlaced, mostCells)) return false;
    return columns.getLayout().numColumns == _layout.numColumns || replaceIfBetter(columns.getLayout());
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
    if (LayoutPieces(other.parts).getCount() > LayoutPieces(_layout.parts).getCount()) return true;
    const std::optional<StabilityReport> report = computeStanding(other.problem, other.parts, _isCancelled);
    if (!report) return false;
    if (!report->stands) return true;
    Planned changed;
    if (!plan(other, changed)) return false;
    if (!changed.plan->exceedsLimitsLessThan(*_planned.plan)) return true;
    _layout = other;
    _planned = changed;
    return true;
}

} // namespace osgLego
