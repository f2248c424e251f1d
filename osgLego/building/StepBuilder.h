#pragma once

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
};

/** Divides the parts of a model or submodel into steps of 5 to 10 parts, at most 12, in an order in which they can be
 * placed from above.
 *
 * If the parts in place would fall after a step, others are placed first, or those that hold them in the same step; if
 * neither helps, they become a submodel with a part above that holds them.
 *
 * Preconditions: joints connect every part to one on the base, directly or not.
 *
 * One thread.
 */
class StepBuilder
{
public:
    /** The parts that fall if only some are in place, none if these stand; nothing if that is not known. */
    using FindFalling = std::function<std::optional<std::vector<std::uint32_t>>(const std::vector<bool>& isPlaced)>;
    /** Called with the number of parts in place after a step; the work is given up if it returns false. */
    using Proceed = std::function<bool(std::size_t numPlaced)>;

    /** @param graph must outlive this object.
     * @param findFalling may be empty. Steps of which nothing is known count as standing. */
    StepBuilder(const JointGraph& graph, FindFalling findFalling, Proceed proceed);

    /** @return nothing if it was given up. */
    std::vector<AssemblyStep> build();

private:
    void regroup();
    UnitList proposeStep();
    void place(const UnitList& units, bool stands);
    void mark(const UnitList& units, bool isPlaced);
    std::vector<std::uint32_t> findFalling(const UnitList& units);
    bool repair(const UnitList& units, const std::vector<std::uint32_t>& falling);
    bool postpone(const UnitList& units, const std::vector<std::uint32_t>& falling);
    bool clamp(const UnitList& units, const std::vector<std::uint32_t>& falling);
    bool hang(const UnitList& units, const std::vector<std::uint32_t>& falling);

    const JointGraph& _graph;
    Symmetry _symmetry;
    PartOrder _order;
    FindFalling _findFalling;
    Proceed _proceed;
    BuildingUnits _units;
    std::unique_ptr<UnitQueue> _queue;
    std::vector<bool> _isPlaced;
    std::vector<bool> _isHung;
    std::vector<bool> _isLost;    // parts that fall whatever is done
    std::vector<bool> _isDelayed; // units
    bool _isKnown = false;        // whether the parts that fall with the units considered last are known
    std::size_t _numPlaced = 0;
    std::vector<AssemblyStep> _steps;
};

} // namespace osgLego
