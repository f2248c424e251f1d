#include <osgLego/search/WindowSearch.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace osgLego
{

namespace
{

constexpr int SMALLEST_WINDOW = 4;
constexpr int LARGEST_WINDOW = 14;
/** The rows of a region in a large layer: more than the parts of a window extend, so that the rows between two regions
 * separate them. */
constexpr int NUM_ROWS = 48;
constexpr int LARGE_LAYER = 2500; // cells

} // namespace

WindowSearch::WindowSearch(PartMap& map, const PartSizes& sizes, const LayoutOptions& options,
                           const std::vector<bool>& isActive) :
    _map(map),
    _options(options), _thickness(sizes.getHeights().size() > 1 ? 6 : 4), _isActive(isActive),
    _windows([&map, &sizes] { return LayoutWindow(map, sizes); })
{
}

std::vector<LayoutRegion> WindowSearch::makeRegions(int layerPhase, int rowPhase) const
{
    const CellLattice& lattice = _map.getLattice();
    const int numLayers = lattice.getNumLayers();
    const int numRows = lattice.getProblem().size.y;
    std::vector<LayoutRegion> regions;
    const auto offset = static_cast<int>(_round * 5 % static_cast<std::uint32_t>(2 * _thickness));
    for (int z = layerPhase * _thickness - offset; z < numLayers; z += 2 * _thickness)
    {
        LayoutRegion region{
            std::max(z, 0), std::min(z + _thickness, numLayers), 0, numRows, _thickness, NUM_ROWS, &_fixedComponents,
            &_isActive};
        if (region.zEnd <= region.zBegin) continue;
        const Index numCells = lattice.getLayerStart(region.zEnd) - lattice.getLayerStart(region.zBegin);
        if (numCells == 0) continue;
        if (numCells < LARGE_LAYER * _thickness)
        {
            if (rowPhase == 0) regions.push_back(region);
            continue;
        }
        const auto rowOffset = static_cast<int>(_round * 37 % (2 * NUM_ROWS));
        for (int y = rowPhase * NUM_ROWS - rowOffset; y < numRows; y += 2 * NUM_ROWS)
        {
            region.yBegin = std::max(y, 0);
            region.yEnd = std::min(y + NUM_ROWS, numRows);
            if (region.yEnd > region.yBegin) regions.push_back(region);
        }
    }
    // The largest regions come first, so that no thread begins one when the others are about to end.
    const auto countCells = [&](const LayoutRegion& region)
    { return lattice.getLayerStart(region.zEnd) - lattice.getLayerStart(region.zBegin); };
    std::ranges::stable_sort(regions, std::greater(), countCells);
    return regions;
}

/** Find the components of the parts outside all regions. */
void WindowSearch::findFixedComponents(const std::vector<LayoutRegion>& regions)
{
    const CellLattice& lattice = _map.getLattice();
    const Index numCells = lattice.getNumCells();
    _fixedComponents.resize(static_cast<std::size_t>(numCells));
    for (Index cell = 0; cell < numCells; ++cell)
        _fixedComponents[static_cast<std::size_t>(cell)] = _map.isAnchor(cell) ? cell : CellLattice::NONE;
    for (const LayoutRegion& region : regions)
        for (Index cell = lattice.getLayerStart(region.zBegin); cell < lattice.getLayerStart(region.zEnd); ++cell)
            if (_map.isAnchor(cell) && region.contains(_map, cell))
                _fixedComponents[static_cast<std::size_t>(cell)] = CellLattice::NONE;
    const auto isFixed = [&](Index anchor)
    { return _fixedComponents[static_cast<std::size_t>(anchor)] != CellLattice::NONE; };
    _components.reset(static_cast<std::size_t>(numCells));
    for (Index cell = 0; cell < numCells; ++cell)
    {
        const Index above = lattice.getNeighbor(cell, CellLattice::ABOVE);
        if (above == CellLattice::NONE) continue;
        if (isFixed(_map.getAnchor(cell)) && isFixed(_map.getAnchor(above)))
            _components.join(_map.getAnchor(cell), _map.getAnchor(above));
    }
    for (Index cell = 0; cell < numCells; ++cell)
        if (isFixed(cell)) _fixedComponents[static_cast<std::size_t>(cell)] = _components.find(cell);
}

bool WindowSearch::runRound(int seamCost, const Limits& limits)
{
    for (int phase = 0; phase < 4; ++phase)
    {
        const std::vector<LayoutRegion> regions = makeRegions(phase % 2, phase / 2);
        if (regions.empty()) continue;
        findFixedComponents(regions);
        if (!improveAll(regions, seamCost, limits)) return false;
    }
    ++_round;
    return true;
}

/** Each thread takes the next region when it is free: a range that oneTBB divides would leave the largest ones to one
 * thread. @return false if it was cancelled. */
bool WindowSearch::improveAll(const std::vector<LayoutRegion>& regions, int seamCost, const Limits& limits)
{
    const auto numThreads = static_cast<std::size_t>(oneapi::tbb::this_task_arena::max_concurrency());
    std::atomic<bool> isStopped = false;
    std::atomic<std::size_t> next = 0;
    const auto improveNext = [&](std::size_t)
    {
        for (std::size_t i = next++; i < regions.size() && !isStopped; i = next++)
            if (isCancelled())
                isStopped = true;
            else
                improve(regions[i], seamCost, limits);
    };
    oneapi::tbb::parallel_for(std::size_t(0), std::min(regions.size(), numThreads), improveNext,
                              oneapi::tbb::simple_partitioner());
    // The loop skips tasks if the group of tasks that it belongs to is cancelled.
    return !isStopped && !isCancelled();
}

void WindowSearch::improve(const LayoutRegion& region, int seamCost, const Limits& limits)
{
    const std::uint64_t position =
        static_cast<std::uint64_t>(region.zBegin) << 32 | static_cast<std::uint64_t>(region.yBegin) << 16;
    LayoutRandom mixed(position ^ static_cast<std::uint64_t>(_round) << 48);
    LayoutRandom random(mixed.next() ^ _options.seed);
    const CellLattice& lattice = _map.getLattice();
    std::vector<Index> seeds;
    for (Index cell = lattice.getLayerStart(region.zBegin); cell < lattice.getLayerStart(region.zEnd); ++cell)
        if (region.hasRowOf(lattice, cell) && _map.isAnchor(cell) && region.isActive(cell) &&
            region.contains(_map, cell))
            seeds.push_back(cell);
    LayoutWindow& window = _windows.local();
    for (std::size_t i = 0; i * limits.partsPerWindow < seeds.size(); ++i)
    {
        if (isCancelled()) return;
        // An earlier window may have replaced the part that began here, by one that is in the region, too.
        const Index anchor = _map.getAnchor(seeds[random.below(seeds.size())]);
        const int numParts =
            SMALLEST_WINDOW + static_cast<int>(random.below(std::size_t(LARGEST_WINDOW - SMALLEST_WINDOW + 1)));
        window.improve(anchor, numParts, seamCost, region, limits.maximumNodes, random);
    }
}

} // namespace osgLego
