#include <osgLego/building/BuildingRegions.h>

#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include <glm/vec3.hpp>

namespace osgLego
{

BuildingRegions::BuildingRegions(const std::vector<BuildingBox>& boxes, const Symmetry& symmetry) :
    _boxes(boxes), _cells(sortCells(boxes)), _ranks(boxes.size(), 0)
{
    _sets.reset(_cells.size());
    const Links links = findIslands();
    joinIslands(links);
    if (symmetry.hasPlane()) joinMirrored(symmetry);
    const std::vector<std::uint32_t> ranks = rankRegions(createRegions(links, symmetry));
    for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(_cells.size()); ++cell)
    {
        const auto& [key, part] = _cells[static_cast<std::size_t>(cell)];
        if (key == toCellKey(_boxes[part].lower))
            _ranks[part] = ranks[_regionOf[static_cast<std::size_t>(_sets.find(cell))]];
    }
}

/** Visit each cell that has a neighbour in the given direction, with that neighbour. */
template <typename Visitor>
void BuildingRegions::visitNeighbors(CellKey way, const Visitor& visit) const
{
    std::size_t neighbor = 0;
    for (std::size_t cell = 0; cell < _cells.size(); ++cell)
    {
        const CellKey wanted = _cells[cell].first + way;
        while (neighbor < _cells.size() && _cells[neighbor].first < wanted)
            ++neighbor;
        if (neighbor < _cells.size() && _cells[neighbor].first == wanted)
            visit(static_cast<std::int32_t>(cell), static_cast<std::int32_t>(neighbor));
    }
}

/** Make the islands of each layer the sets of cells. @return the islands that touch, each pair once. */
BuildingRegions::Links BuildingRegions::findIslands()
{
    for (const CellKey way : {CELL_RIGHT, CELL_BEHIND})
        visitNeighbors(way, [this](std::int32_t cell, std::int32_t neighbor) { _sets.join(cell, neighbor); });
    Links links;
    visitNeighbors(CELL_ABOVE, [&](std::int32_t cell, std::int32_t above)
                   { links.emplace_back(_sets.find(cell), _sets.find(above)); });
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
    return links;
}

/** Join islands that touch only each other upwards and downwards. */
void BuildingRegions::joinIslands(const Links& links)
{
    std::vector<std::uint32_t> numAbove(_cells.size(), 0);
    std::vector<std::uint32_t> numBelow(_cells.size(), 0);
    for (const auto& [low, high] : links)
    {
        ++numAbove[static_cast<std::size_t>(low)];
        ++numBelow[static_cast<std::size_t>(high)];
    }
    for (const auto& [low, high] : links)
        if (numAbove[static_cast<std::size_t>(low)] == 1 && numBelow[static_cast<std::size_t>(high)] == 1)
            _sets.join(low, high);
}

/** Join regions most of whose cells mirror each other. */
void BuildingRegions::joinMirrored(const Symmetry& symmetry)
{
    std::map<std::int32_t, std::size_t> numCells;
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> numMirrored;
    for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(_cells.size()); ++cell)
    {
        const CellKey key = _cells[static_cast<std::size_t>(cell)].first;
        const glm::ivec3 place(key & 0xffff, key >> 16 & 0xffff, key >> 32);
        const glm::ivec3 mirrored = symmetry.mirror({place, place + 1}).lower;
        const auto other = std::lower_bound(_cells.begin(), _cells.end(), std::pair(toCellKey(mirrored), 0u));
        ++numCells[_sets.find(cell)];
        if (other == _cells.end() || other->first != toCellKey(mirrored)) continue;
        ++numMirrored[{_sets.find(cell), _sets.find(static_cast<std::int32_t>(other - _cells.begin()))}];
    }
    for (const auto& [pair, count] : numMirrored)
        if (2 * count > numCells[pair.first] && 2 * count > numCells[pair.second]) _sets.join(pair.first, pair.second);
}

std::vector<BuildingRegions::Region> BuildingRegions::createRegions(const Links& links, const Symmetry& symmetry)
{
    std::vector<Region> regions;
    std::vector<std::size_t> counts;
    std::vector<glm::dvec3> sums;
    _regionOf.assign(_cells.size(), 0);
    for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(_cells.size()); ++cell)
    {
        const auto index = static_cast<std::size_t>(cell);
        const BuildingBox& box = _boxes[_cells[index].second];
        const auto first = static_cast<std::size_t>(_sets.find(cell));
        if (first == index)
        {
            _regionOf[index] = static_cast<std::uint32_t>(regions.size());
            regions.push_back({static_cast<int>(_cells[index].first >> 32), {}, 0, {}});
            sums.emplace_back(0.0);
            counts.push_back(0);
        }
        sums[_regionOf[first]] += glm::dvec3(symmetry.fold(box.lower + box.upper));
        ++counts[_regionOf[first]];
    }
    for (std::size_t region = 0; region < regions.size(); ++region)
        regions[region].center = glm::ivec3(sums[region] / static_cast<double>(counts[region]));
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    for (const auto& [low, high] : links)
    {
        const std::uint32_t below = _regionOf[static_cast<std::size_t>(_sets.find(low))];
        const std::uint32_t above = _regionOf[static_cast<std::size_t>(_sets.find(high))];
        if (below == above || !known.emplace(below, above).second) continue;
        regions[below].above.push_back(above);
        ++regions[above].numBelow;
    }
    return regions;
}

/** Order regions: the lowest first, then the nearest to the previous one. Regions that touch a region from below come
 * before it.
 */
std::vector<std::uint32_t> BuildingRegions::rankRegions(std::vector<Region> regions) const
{
    std::vector<std::uint32_t> ranks(regions.size(), 0);
    std::map<int, std::vector<std::uint32_t>> open; // by the lowest layer
    for (std::uint32_t region = 0; region < regions.size(); ++region)
        if (regions[region].numBelow == 0) open[regions[region].lowest].push_back(region);
    glm::ivec3 place(0);
    for (std::uint32_t rank = 0; !open.empty(); ++rank)
    {
        std::vector<std::uint32_t>& lowest = open.begin()->second;
        const auto distance = [&](std::uint32_t region)
        {
            const glm::ivec3 way = regions[region].center - place;
            return std::pair(std::abs(way.x) + std::abs(way.y), region);
        };
        const auto nearest = std::min_element(
            lowest.begin(), lowest.end(), [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); });
        const std::uint32_t region = *nearest;
        lowest.erase(nearest);
        if (lowest.empty()) open.erase(open.begin());
        ranks[region] = rank;
        place = regions[region].center;
        for (const std::uint32_t above : regions[region].above)
            if (--regions[above].numBelow == 0) open[regions[above].lowest].push_back(above);
    }
    return ranks;
}

} // namespace osgLego
