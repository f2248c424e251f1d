#pragma once

#include <osgLego/BuildingPlan.h>
#include <osgLego/data/UnionFind.h>
#include <osgLego/stability/JointGraph.h>

#include <utility>
#include <vector>

namespace osgLego
{

/** Groups parts that can only be put in place together: units of one part, or of several that become a submodel.
 *
 * Parts that no upward path of joints from the base reaches hang. Each connected group of hanging parts becomes a unit
 * with one part from which it hangs; other parts above it are pressed down on it later. Units of which each has to be
 * placed before the other become one if joints connect them.
 *
 * A unit of few parts is joined in one hand, and placed so. Hanging parts that would make a unit too large are pressed
 * on from below instead, one by one, each after a part that it touches.
 *
 * Usage:
 *
 *     BuildingUnits units(graph);
 *     units.group(isPlaced, isHung);
 *     for (const BuildingUnits::Unit& unit : units.getUnits()) ...
 *
 * Preconditions: joints connect every part to one on the base, directly or not.
 *
 * One thread.
 */
class BuildingUnits
{
public:
    static constexpr std::uint32_t NONE = 0xffffffff;
    static constexpr std::size_t MOST_IN_HAND = 3; //!< parts that are joined in one hand; more become a submodel
    static constexpr std::size_t MOST_PARTS = BuildingPlan::MOST_SUBMODEL_PARTS;

    struct Unit
    {
        std::vector<std::uint32_t> parts; //!< those in a hand in the order of joining, others in ascending order
        std::vector<std::uint32_t> next;  //!< units that must be placed later, each once
        std::size_t numBefore = 0;        //!< units that must be placed earlier

        bool isSubmodel() const { return parts.size() > MOST_IN_HAND; }
    };

    /** @param graph must outlive this object.
     * @param mostParts of a unit, at least 1. */
    explicit BuildingUnits(const JointGraph& graph, std::size_t mostParts = MOST_PARTS) :
        _graph(graph), _mostParts(mostParts), _isAlone(graph.getNumParts(), false)
    {
    }

    /** Group the parts that are not placed yet.
     * @param isHung parts that hang although there are joints below them; none of these are on the base. */
    void group(const std::vector<bool>& isPlaced, const std::vector<bool>& isHung);

    const JointGraph& getGraph() const { return _graph; }
    const std::vector<Unit>& getUnits() const { return _units; }
    /** The unit of a part; NONE if it was placed before. */
    std::uint32_t getUnitOf(std::uint32_t part) const { return _unitOf[part]; }
    /** Whether a part hangs, and is pressed on from below. */
    bool isPressedOn(std::uint32_t part) const { return _isPressedOn[part]; }

private:
    using PartList = std::vector<std::uint32_t>;
    using UnitNumbers = std::vector<std::uint32_t>;

    void findSupported(const std::vector<bool>& isPlaced, const std::vector<bool>& isHung);
    void hangGroups(const std::vector<bool>& isPlaced);
    void hangGroup(const PartList& hanging, const std::vector<bool>& isPlaced);
    void pressOn(const PartList& hanging, const std::vector<bool>& isPlaced);
    std::uint32_t chooseHolder(const PartList& hanging, const std::vector<bool>& isPlaced) const;
    void createUnits(const std::vector<bool>& isPlaced);
    void sortInHand(PartList& parts) const;
    void linkUnits();
    bool joinCycles(const std::vector<UnitNumbers>& cycles);
    bool breakCycles(const std::vector<UnitNumbers>& cycles, const std::vector<bool>& isHung);
    std::vector<UnitNumbers> findCycles() const;
    bool isTooLarge(const UnitNumbers& units) const;
    bool canBeSplit(std::uint32_t unit, const std::vector<bool>& isHung) const;

    const JointGraph& _graph;
    std::size_t _mostParts;
    std::vector<bool> _isAlone; // hanging parts that no unit of several parts may contain
    std::vector<bool> _isSupported;
    std::vector<bool> _isPressedOn;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> _pressed; // parts, and others pressed on them
    UnionFind _sets;                                               // of parts
    std::vector<std::uint32_t> _unitOf;
    std::vector<Unit> _units;
};

} // namespace osgLego
