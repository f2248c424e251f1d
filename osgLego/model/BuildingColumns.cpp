#include <osgLego/model/BuildingColumns.h>

#include <osgLego/BuildingPlanner.h>
#include <osgLego/model/LayerColumns.h>
#include <osgLego/model/LayoutPieces.h>
#include <osgLego/model/LayoutStanding.h>

#include <array>
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

} // namespace

bool BuildingColumns::run()
{
    if (_layout.parts.size() > MOST_PARTS) return true;
    _plan = plan(_layout);
    if (!_plan) return false;
    const SupportedLayout original = _layout;
    for (const ColumnLimits& limits : ATTEMPTS)
    {
        if (_plan->keepsLimits()) break;
        LayerColumns columns(original, limits.mostHanging, limits.mostAdded, _isCancelled);
        const bool isDone = columns.run();
        if (isCancelled()) return false;
        if (isDone && !replaceIfBetter(columns.getLayout())) return false;
    }
    _layout.numBuildingColumns = _layout.numColumns - original.numColumns;
    _layout.largestSubmodel = _plan->getLargestSubmodel();
    _layout.deepestSubmodel = _plan->getDeepestSubmodel();
    _layout.numFallingSteps = _plan->getNumFalling();
    return true;
}

osg::ref_ptr<const BuildingPlan> BuildingColumns::plan(const SupportedLayout& layout) const
{
    PlanningOptions options;
    options.isCancelled = _isCancelled;
    return planBuilding(*_createModel(layout.parts), options);
}

/** Replace the layout by one with other columns, if that is easier to build. @return false if it was cancelled. */
bool BuildingColumns::replaceIfBetter(const SupportedLayout& other)
{
    if (LayoutPieces(other.parts).getCount() > LayoutPieces(_layout.parts).getCount()) return true;
    const std::optional<StabilityReport> report = computeStanding(other.problem, other.parts, _isCancelled);
    if (!report) return false;
    if (!report->stands) return true;
    const osg::ref_ptr<const BuildingPlan> changed = plan(other);
    if (!changed) return false;
    if (!changed->exceedsLimitsLessThan(*_plan) || changed->getNumFalling() > _plan->getNumFalling()) return true;
    _layout = other;
    _plan = changed;
    return true;
}

} // namespace osgLego
