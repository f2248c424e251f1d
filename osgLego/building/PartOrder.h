#pragma once

#include <osgLego/building/Symmetry.h>

#include <vector>

namespace osgLego
{

/** The preferred order of parts: region by region, in each of them layer by layer, and in a layer along a walk from
 * neighbour to neighbour, with parts that mirror each other together. joinEarly() then moves parts that join others to
 * an earlier place.
 *
 * Immutable once created; every function may be called from any thread. */
class PartOrder
{
public:
    /** The arguments must outlive this object. */
    PartOrder(const JointGraph& graph, const Symmetry& symmetry);

    std::uint32_t getRank(std::uint32_t part) const { return _ranks[part]; }
    /** The number of the part's layer of a region, in the order of building. */
    std::uint32_t getGroup(std::uint32_t part) const { return _groups[part]; }

private:
    void walk(std::vector<std::uint32_t>& parts, glm::ivec3& place) const;
    void sortByBands(std::vector<std::uint32_t>& parts) const;

    const std::vector<BuildingBox>& _boxes;
    const Symmetry& _symmetry;
    std::vector<std::uint32_t> _ranks;
    std::vector<std::uint32_t> _groups;
};

} // namespace osgLego
