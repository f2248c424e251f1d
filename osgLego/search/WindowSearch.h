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
 * A round has phases. In each phase, threads work on regions that unchanged layers or rows separate, so that the result
 * does not depend on the number of threads. */
class WindowSearch
{
public:
    using Index = CellLattice::Index;

    /** The amount of work in a round. */
    struct Limits
    {
        std::size_t partsPerWindow = 1; //!< number of parts in the model for each window
        int maximumNodes = 0;           //!< maximum number of steps of the search in one window
    };

    /** @param isActive for each cell, whether parts that begin there may change; empty: all parts may. */
    WindowSearch(PartMap& map, const PartSizes& sizes, const LayoutOptions& options, const std::vector<bool>& isActive);

    /** Improve windows throughout the model.
     * @param seamCost the cost of half a unit of stacked seams.
     * @return false if it was cancelled. */
    bool runRound(int seamCost, const Limits& limits);

    /** The regions on which threads work at the same time in a phase of the next round. The distance between two
     * regions is greater than their margins, in layers or in rows. @param layerPhase 0 or 1. @param rowPhase 0 or 1. */
    std::vector<LayoutRegion> makeRegions(int layerPhase, int rowPhase) const;

private:
    void findFixedComponents(const std::vector<LayoutRegion>& regions);
    bool improveAll(const std::vector<LayoutRegion>& regions, int seamCost, const Limits& limits);
    void improve(const LayoutRegion& region, int seamCost, const Limits& limits);
    bool isCancelled() const { return _options.isCancelled && _options.isCancelled(); }

    PartMap& _map;
    const LayoutOptions& _options;
    int _thickness; //!< of a region, in layers
    const std::vector<bool>& _isActive;
    std::uint32_t _round = 0;
    std::vector<Index> _fixedComponents;
    UnionFind _components;
    oneapi::tbb::enumerable_thread_specific<LayoutWindow> _windows;
};

} // namespace osgLego
