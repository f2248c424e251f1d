#pragma once

#include <osgLego/building/StepViews.h>
#include <osgLego/building/UnitQueue.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace osgLego
{

/** A step of a model or submodel, with the submodels in it as their parts. */
struct AssemblyStep
{
    std::vector<std::uint32_t> parts;
    std::vector<std::vector<std::uint32_t>> submodels;
    bool stands = true;
    bool isChecked = false; // whether `stands` is known
    int turns = 0;          // of the view, as BuildingStep::turns
};

/** Divides the parts of a model or submodel into steps of 5 to 10 parts, at most 12, in an order in which they can be
 * placed from above.
 *
 * A step is shortened, to no fewer than 5 parts, if some would be hidden in every view. A last step of one part is
 * joined with the step before, or gets a second part from there.
 *
 * If parts fall after a step, the parts that hold them are placed in the same step, or other parts are placed first. If
 * neither helps, the falling parts become a submodel with a part above that holds them.
 *
 * Preconditions: joints connect every part to one on the base, directly or not.
 *
 * One thread.
 */
class StepBuilder
{
public:
    /** Finds the parts that fall if only some are in place. Returns none if these stand, and nothing if that is not
     * known. */
    using FindFalling = std::function<std::optional<std::vector<std::uint32_t>>(const std::vector<bool>& isPlaced)>;
    /** Called with the number of parts in place after a step, and whether they stand; build() ends if it returns
     * false. */
    using Proceed = std::function<bool(std::size_t numPlaced, bool stands)>;

    /** @param graph must outlive this object.
     * @param findFalling may be empty. Steps for which it returns nothing count as standing.
     * @param views of the parts of `graph`, none of them in place; null if all steps have the same view.
     * @param mostParts of a submodel. */
    StepBuilder(const JointGraph& graph, FindFalling findFalling, Proceed proceed, StepViews* views = nullptr,
                std::size_t mostParts = BuildingUnits::MOST_PARTS);

    /** @return nothing if it was given up. */
    std::vector<AssemblyStep> build();

private:
    void regroup();
    void fillLastStep();
    bool isBelow(std::uint32_t part, const std::vector<std::vector<std::uint32_t>>& submodels) const;
    UnitList proposeStep();
    UnitList propose();
    bool canShow(const UnitList& units, bool isTurning) const;
    void shorten(UnitList& units) const;
    bool leavesOne(const UnitList& shorter, const UnitList& units) const;
    void place(const UnitList& units, bool stands);
    bool canBeSubmodel(std::uint32_t unit, const UnitList& units) const;
    void mark(const UnitList& units, bool isPlaced);
    std::vector<std::uint32_t> findFalling(const UnitList& units);
    bool isLost(const std::vector<std::uint32_t>& falling) const;
    bool repair(const UnitList& units, const std::vector<std::uint32_t>& falling);
    bool postpone(const UnitList& units, const std::vector<std::uint32_t>& falling);
    bool clamp(const UnitList& units, const std::vector<std::uint32_t>& falling);
    bool hang(const UnitList& units, const std::vector<std::uint32_t>& falling);
    bool defer(const UnitList& units, const std::vector<std::uint32_t>& falling);

    const JointGraph& _graph;
    Symmetry _symmetry;
    PartOrder _order;
    FindFalling _findFalling;
    Proceed _proceed;
    StepViews* _views;
    BuildingUnits _units;
    bool _hasSubmodels;
    std::unique_ptr<UnitQueue> _queue;
    std::vector<bool> _isPlaced;
    std::vector<bool> _isHung;
    std::vector<bool> _isLost;     // parts that fall after every repair
    std::vector<bool> _isDeferred; // parts that fall, or let others fall, after every repair, until they are placed
    std::vector<bool> _isDelayed;  // units
    bool _isKnown = false;         // whether findFalling returned a result for the units considered last
    std::size_t _numPlaced = 0;
    std::vector<AssemblyStep> _steps;
};

} // namespace osgLego
