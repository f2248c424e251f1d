#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/BuildingPlan.h>
#include <osgLego/model/SupportedLayout.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <osg/ref_ptr>

namespace osgLego
{

class LayerColumns;

/** Adds columns to a layout that stands, and whose building plan needs submodels that are too large or nested too deep,
 * or too many steps after which the model has to be held.
 *
 * LayerColumns proposes columns, with several sizes of submodels, and then StepColumns some below what still falls. The
 * building plan on a table judges them: columns are added only if it then exceeds the limits of BuildingPlan less, and
 * if there are no more pieces. In the end, columns that the limits do not need are removed, those that are seen most
 * first, in a limited number of attempts.
 *
 * Usage:
 *
 *     BuildingColumns columns(layout, [&](const LaidParts& parts) { return createModel(parts, grid, colors); },
 *                             isCancelled, progress);
 *     if (!columns.run()) ... // cancelled
 *
 * The arguments but `createModel` must exist as long as this object. One thread, which uses all threads that oneTBB
 * gives it. */
class BuildingColumns
{
public:
    /** Larger layouts are left unchanged, since planning takes long. */
    static constexpr std::size_t MOST_PARTS = 2000;

    /** Makes the model that is built; the plan depends on its axes. */
    using CreateModel = std::function<osg::ref_ptr<const BrickModel>(const LaidParts& parts)>;

    /** @param isCancelled and progress may be empty. The latter is called with the fraction done, 0 to 1. */
    BuildingColumns(SupportedLayout& layout, CreateModel createModel, const std::function<bool()>& isCancelled,
                    const std::function<void(double)>& progress) :
        _layout(layout),
        _createModel(std::move(createModel)), _isCancelled(isCancelled), _progress(progress)
    {
    }

    /** @return false if it was cancelled. */
    bool run();

private:
    /** The model of a layout, and its building plan; null if there is none. */
    struct Planned
    {
        osg::ref_ptr<const BrickModel> model;
        osg::ref_ptr<const BuildingPlan> plan;
    };

    bool plan(const SupportedLayout& layout, std::size_t mostFalling, Planned& planned) const;
    bool isAsEasyWithoutChecks(const SupportedLayout& layout) const;
    bool addBelowLayers(const SupportedLayout& original);
    bool add(LayerColumns& columns, std::size_t mostCells);
    bool addAnew(std::size_t mostHanging, std::size_t mostCells);
    bool addBelowSteps(std::size_t mostCells);
    bool addBelowFallingSteps(std::size_t mostCells);
    bool removeUnneeded(std::size_t numNeeded);
    bool removeIfUnneeded(std::span<const SupportColumn> columns, bool& isRemoved);
    std::vector<std::uint32_t> findRanks() const;
    bool replaceIfBetter(const SupportedLayout& other);
    bool hasMorePieces(const SupportedLayout& other) const;
    bool findPlanIfStanding(const SupportedLayout& layout, std::size_t mostFalling, Planned& planned) const;
    void report(double fraction) const;
    bool isCancelled() const { return _isCancelled && _isCancelled(); }

    SupportedLayout& _layout;
    CreateModel _createModel;
    const std::function<bool()>& _isCancelled;
    const std::function<void(double)>& _progress;
    Planned _planned; //!< of the layout
};

} // namespace osgLego
