#pragma once

#include <osgLego/building/BuildingUnits.h>
#include <osgLego/building/PartOrder.h>

#include <set>
#include <span>
#include <utility>
#include <vector>

namespace osgLego
{

/** Units in the order of building, as numbers for BuildingUnits::getUnits(). */
using UnitList = std::vector<std::uint32_t>;

/** The units that are still to be placed, from which steps are taken. One thread. */
class UnitQueue
{
public:
    /** Parts of a step, if possible; a submodel counts as SUBMODEL_WEIGHT parts, or as LARGE_WEIGHT if it has more than
     * MOST parts. */
    static constexpr std::size_t LEAST = 5;
    static constexpr std::size_t USUAL = 8;
    static constexpr std::size_t USUAL_MOST = 10;
    static constexpr std::size_t MOST = 12;
    static constexpr std::size_t SUBMODEL_WEIGHT = 2;
    static constexpr std::size_t LARGE_WEIGHT = 5;

    /** The arguments must outlive this object, and units must not be grouped again. */
    UnitQueue(const BuildingUnits& units, const PartOrder& order, const Symmetry& symmetry);

    bool isEmpty() const { return _numOpen == 0; }
    /** The number of units that are still to be placed. */
    std::size_t getNumOpen() const { return _numOpen; }
    /** The units of the next step: the first that can be placed.
     * @param isAvoided units that are not used; empty if all may be. */
    UnitList propose(const std::vector<bool>& isAvoided);
    /** Remove units, which are placed now. */
    void take(const UnitList& units);

    /** Add a unit and all that must be placed before it, in order, to units that are not empty.
     * @return false if these weigh more than MOST, even if large submodels count as SUBMODEL_WEIGHT: submodels that
     * hold each other have to be in one step. */
    bool addWithAllBefore(std::uint32_t unit, UnitList& units) const { return addWithAllBefore(unit, units, 0); }
    /** Whether no part must be placed after a submodel among the units. */
    bool isOneStep(const UnitList& units) const;

    std::size_t getWeight(const UnitList& units) const { return getWeight(units, LARGE_WEIGHT); }
    /** The weight of a submodel. */
    static std::size_t getSubmodelWeight(std::size_t numParts)
    {
        return numParts > MOST ? LARGE_WEIGHT : SUBMODEL_WEIGHT;
    }
    bool isSubmodel(std::uint32_t unit) const { return _units.getUnits()[unit].isSubmodel(); }
    /** The number of submodels of more than MOST parts that don't mirror the one before; the first is not counted. */
    int countUnmirroredLarge(std::span<const std::uint32_t> units) const;

private:
    bool isLarge(std::uint32_t unit) const { return isSubmodel(unit) && _units.getUnits()[unit].parts.size() > MOST; }
    bool addWithAllBefore(std::uint32_t unit, UnitList& units, std::size_t openWeight) const;
    std::size_t getWeight(const UnitList& units, std::size_t largeWeight) const;
    std::pair<std::uint32_t, std::uint32_t> getKey(std::uint32_t unit) const { return {_ranks[unit], unit}; }
    std::uint32_t getLastPart(std::uint32_t unit) const;
    UnitList lookAhead(const std::vector<bool>& isAvoided);
    bool isAfterSubmodel(std::uint32_t unit, const UnitList& others) const;
    void release(std::uint32_t unit);
    void withdraw(std::uint32_t unit);
    std::size_t chooseLength(const UnitList& units) const;
    int getPenalty(const UnitList& units, std::size_t length, std::size_t weight) const;
    bool areTwins(std::uint32_t unit, std::uint32_t other) const;
    std::uint32_t findForced() const;
    bool isHeld(std::uint32_t unit) const;

    const BuildingUnits& _units;
    const PartOrder& _order;
    const Symmetry& _symmetry;
    std::vector<std::uint32_t> _ranks;
    std::vector<std::size_t> _numBefore; // units that are not placed
    std::vector<UnitList> _before;
    std::vector<bool> _isTaken;
    std::set<std::pair<std::uint32_t, std::uint32_t>> _ready; // ranks and units
    std::size_t _numOpen = 0;
};

} // namespace osgLego
