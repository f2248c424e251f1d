#include "LayoutBound.h"

#include "RegionBound.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

#include <oneapi/tbb/parallel_for.h>

namespace osgLego
{

namespace
{

using Region = std::vector<LayoutCell>;

struct RegionOrder
{
    bool operator()(const Region& a, const Region& b) const
    {
        const auto isBefore = [](const LayoutCell& first, const LayoutCell& second)
        { return std::tie(first.place, first.color) < std::tie(second.place, second.color); };
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), isBefore);
    }
};

/** The different regions, and the index of each. */
using RegionIndices = std::map<Region, std::size_t, RegionOrder>;

std::span<const LayoutCell> getLayer(const LayoutProblem& problem, int z)
{
    const auto isBelow = [](const LayoutCell& cell, int height) { return cell.place[2] < height; };
    const auto begin = std::lower_bound(problem.cells.begin(), problem.cells.end(), z, isBelow);
    return {begin, std::lower_bound(begin, problem.cells.end(), z + 1, isBelow)};
}

/** Divides a layer into regions that no part can connect. */
class Regions
{
public:
    explicit Regions(std::span<const LayoutCell> layer) : _layer(layer), _labels(layer.size(), NONE)
    {
        for (std::size_t cell = 0; cell < layer.size(); ++cell)
            _indices.emplace(std::array{layer[cell].place[0], layer[cell].place[1]}, cell);
        for (std::size_t cell = 0; cell < layer.size(); ++cell)
            if (_labels[cell] == NONE) fill(cell);
        collect();
    }

    std::vector<Region> regions; //!< moved to the origin

private:
    static constexpr std::size_t NONE = std::numeric_limits<std::size_t>::max();

    void fill(std::size_t first)
    {
        _labels[first] = _numRegions;
        std::vector<std::size_t> open{first};
        while (!open.empty())
        {
            const LayoutCell& cell = _layer[open.back()];
            open.pop_back();
            for (const auto& [x, y] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
            {
                const auto neighbour = _indices.find(
                    {static_cast<std::uint16_t>(cell.place[0] + x), static_cast<std::uint16_t>(cell.place[1] + y)});
                if (neighbour == _indices.end() || _labels[neighbour->second] != NONE ||
                    !suit(cell.color, _layer[neighbour->second].color))
                    continue;
                _labels[neighbour->second] = _numRegions;
                open.push_back(neighbour->second);
            }
        }
        ++_numRegions;
    }

    static bool suit(std::uint16_t first, std::uint16_t second)
    {
        return first == second || first == LayoutCell::ANY_COLOR || second == LayoutCell::ANY_COLOR;
    }

    void collect()
    {
        regions.resize(_numRegions);
        for (std::size_t cell = 0; cell < _layer.size(); ++cell)
            regions[_labels[cell]].push_back(_layer[cell]);
        for (Region& region : regions)
            moveToOrigin(region);
    }

    static void moveToOrigin(Region& region)
    {
        std::array<std::uint16_t, 2> lowest{0xffff, 0xffff};
        for (const LayoutCell& cell : region)
            for (std::size_t axis = 0; axis < 2; ++axis)
                lowest[axis] = std::min(lowest[axis], cell.place[axis]);
        for (LayoutCell& cell : region)
            cell.place = {static_cast<std::uint16_t>(cell.place[0] - lowest[0]),
                          static_cast<std::uint16_t>(cell.place[1] - lowest[1]), 0};
    }

    std::span<const LayoutCell> _layer;
    std::map<std::array<std::uint16_t, 2>, std::size_t> _indices;
    std::vector<std::size_t> _labels; //!< the region of each cell
    std::size_t _numRegions = 0;
};

/** The regions of some layers. */
struct RegionTable
{
    RegionTable(const LayoutProblem& problem, const std::vector<int>& layers)
    {
        for (const int z : layers)
        {
            std::vector<std::size_t>& found = regionsOfLayers.emplace_back();
            for (const Region& region : Regions(getLayer(problem, z)).regions)
                found.push_back(indices.emplace(region, indices.size()).first->second);
        }
    }

    RegionIndices indices;
    std::vector<std::vector<std::size_t>> regionsOfLayers;
};

/** Compute the bounds of all regions, the largest first, since they take longest. */
std::vector<RegionBound> boundRegions(const RegionIndices& indices, const std::vector<LayoutColor>& colors,
                                      const BoundOptions& options)
{
    std::vector<const RegionIndices::value_type*> entries;
    for (const auto& entry : indices)
        entries.push_back(&entry);
    std::sort(entries.begin(), entries.end(),
              [](const auto* a, const auto* b) { return a->first.size() > b->first.size(); });
    std::vector<RegionBound> bounds(indices.size());
    // Ranges of one region: threads take them one by one, in about this order.
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, entries.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range)
        {
            for (std::size_t entry = range.begin(); entry < range.end(); ++entry)
                if (!options.isCancelled || !options.isCancelled())
                    bounds[entries[entry]->second] =
                        boundRegion(entries[entry]->first, colors, options.seconds, options.isCancelled);
        },
        tbb::simple_partitioner());
    return bounds;
}

std::vector<int> findLayers(const LayoutProblem& problem)
{
    std::vector<int> layers;
    for (const LayoutCell& cell : problem.cells)
        if (layers.empty() || layers.back() != cell.place[2]) layers.push_back(cell.place[2]);
    return layers;
}

} // namespace

std::vector<LayerBound> boundLayers(const LayoutProblem& problem, std::vector<int> layers, const BoundOptions& options)
{
    if (layers.empty()) layers = findLayers(problem);
    const RegionTable table(problem, layers);
    const std::vector<RegionBound> bounds = boundRegions(table.indices, problem.colors, options);
    if (options.isCancelled && options.isCancelled()) return {};
    std::vector<LayerBound> result;
    for (std::size_t layer = 0; layer < layers.size(); ++layer)
    {
        LayerBound& bound = result.emplace_back();
        bound.z = layers[layer];
        for (const std::size_t region : table.regionsOfLayers[layer])
        {
            bound.parts += bounds[region].parts;
            bound.isOptimum &= bounds[region].isOptimum;
        }
    }
    return result;
}

} // namespace osgLego
