#pragma once

#include <osgLego/data/UnionFind.h>
#include <osgLego/stability/JointGraph.h>

#include <vector>

namespace osgLego
{

/** Groups parts that can only be put in place together: units of one part, or of several that become a submodel.
 *
 * Parts that no upward path of joints from the base reaches hang. Each connected group of hanging parts becomes a unit
 * with one part from which it hangs; other parts above it are pressed down on it later. Units of which each has to be
 * placed before the other become one if joints connect them.
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

    struct Unit
    {
        std::vector<std::uint32_t> parts; //!< in ascending order
        std::vector<std::uint32_t> next;  //!< units that must be placed later, each once
        std::size_t numBefore = 0;        //!< units that must be placed earlier
    };

    /** @param graph must outlive this object. */
    explicit BuildingUnits(const JointGraph& graph) : _graph(graph) {}

    /** Group the parts that are not placed yet.
     * @param isHung parts that hang although there are joints below them; none of these are on the base. */
    void group(const std::vector<bool>& isPlaced, const std::vector<bool>& isHung);

    const JointGraph& getGraph() const { return _graph; }
    const std::vector<Unit>& getUnits() const { return _units; }
    /** The unit of a part; NONE if it was placed before. */
    std::uint32_t getUnitOf(std::uint32_t part) const { return _unitOf[part]; }

private:
    void findSupported(const std::vector<bool>& isPlaced, const std::vector<bool>& isHung);
    void hangGroups(const std::vector<bool>& isPlaced);
    std::uint32_t chooseHolder(const std::vector<std::uint32_t>& hanging, const std::vector<bool>& isPlaced) const;
    void createUnits(const std::vector<bool>& isPlaced);
    void linkUnits();
    bool joinCycles();

    const JointGraph& _graph;
    std::vector<bool> _isSupported;
    UnionFind _sets; // of parts
    std::vector<std::uint32_t> _unitOf;
    std::vector<Unit> _units;
};

} // namespace osgLego
