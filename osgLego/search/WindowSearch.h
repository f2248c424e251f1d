#pragma once

#include <osgLego/layout/PartMap.h>
#include <osgLego/search/LayoutOptions.h>
#include <osgLego/search/LayoutRegion.h>
#include <osgLego/search/LayoutWindow.h>

#include <cstdint>
#include <functional>
#include <vector>

#include <oneapi/tbb/enumerable_thread_specific.h>

namespace osgLego
{

/** Improves a layout window by window, in several threads.
 *
 * A round has phases, in each of which threads work on regions with
 * layers or rows between them that nobody changes, so that the result does not depend on the number of threads. */
class WindowSearch
{
public:
    using Index = CellLattice::Index;

    /** The work of a round. */
    struct Limits
    {
        std::size_t partsPerWindow = 1; //!< the number of parts for each window that is laid
        int maximumNodes = 0;           //!< steps of the search for one window
    };

    /** @param isActive whether windows may begin at a cell; empty: at all cells. */
    WindowSearch(PartMap& map, const PartSizes& sizes, const LayoutOptions& options, const std::vector<bool>& isActive);

    /** Lay windows throughout the model.
     * @param seamCost of half a unit of stacked seams.
     * @return false if it was cancelled. */
    bool runRound(int seamCost, const Limits& limits);

    /** The regions on which threads work at the same time in a phase of the next round. Each is farther from the others
     * than its margins reach, in layers or in rows. @param layerPhase 0 or 1. @param rowPhase 0 or 1. */
    std::vector<LayoutRegion> makeRegions(int layerPhase, int rowPhase) const;

private:
    void findFixedComponents(const std::vector<LayoutRegion>& regions);
    void improve(const LayoutRegion& region, int seamCost, const Limits& limits, LayoutRandom& random);
    bool isCancelled() const { return _options.isCancelled && _options.isCancelled(); }

    PartMap& _map;
    const LayoutOptions& _options;
    int _thickness; //!< of regions, in layers
    const std::vector<bool>& _isActive;
    std::uint32_t _round = 0;
    std::vector<Index> _fixedComponents;
    UnionFind _components;
    oneapi::tbb::enumerable_thread_specific<LayoutWindow> _windows;
};

} // namespace osgLego
