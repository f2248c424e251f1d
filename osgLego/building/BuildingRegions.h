#pragma once

#include <osgLego/building/Symmetry.h>
#include <osgLego/data/CellKeys.h>
#include <osgLego/data/UnionFind.h>

#include <vector>

namespace osgLego
{

/** Regions of a model that are built one after the other, such as legs and towers: the islands of its layers, joined
 * upwards as long as they neither branch nor meet. Regions that mirror each other count as one.
 *
 * Immutable once created; every function may be called from any thread. */
class BuildingRegions
{
public:
    BuildingRegions(const std::vector<BuildingBox>& boxes, const Symmetry& symmetry);

    /** The place of a part's region in the order of building, from 0 on. */
    std::uint32_t getRank(std::uint32_t part) const { return _ranks[part]; }

private:
    using Links = std::vector<std::pair<std::int32_t, std::int32_t>>; // from an island or region to another above it

    struct Region
    {
        int lowest = 0;
        glm::ivec3 center{0}; // in half cells
        std::size_t numBelow = 0;
        std::vector<std::uint32_t> above;
    };

    Links findIslands();
    void joinIslands(const Links& links);
    void joinMirrored(const Symmetry& symmetry);
    std::vector<Region> createRegions(const Links& links, const Symmetry& symmetry);
    std::vector<std::uint32_t> rankRegions(std::vector<Region> regions) const;
    template <typename Visitor>
    void visitNeighbors(CellKey way, const Visitor& visit) const;

    const std::vector<BuildingBox>& _boxes;
    std::vector<std::pair<CellKey, std::uint32_t>> _cells;
    UnionFind _sets;                      // of cells: islands, then regions
    std::vector<std::uint32_t> _regionOf; // for each cell that represents a region
    std::vector<std::uint32_t> _ranks;
};

} // namespace osgLego
