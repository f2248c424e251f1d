#pragma once

#include <osgLego/search/ConnectionCheck.h>
#include <osgLego/search/ExactCover.h>
#include <osgLego/search/LayoutRandom.h>
#include <osgLego/search/WindowBuilder.h>

#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** Improves a layout by replacing a few neighbouring parts with the cheapest cover of their cells.
 *
 * Keeps its memory from one window to the next. One thread at a time; several objects may work on regions of one layout
 * that don't touch. */
class LayoutWindow
{
public:
    using Index = CellLattice::Index;

    LayoutWindow(PartMap& map, const PartSizes& sizes);

    /** Replace a part and up to `numParts` - 1 parts near it, if that is cheaper and separates no parts.
     * @param seamCost the cost of half a unit of stacked seams.
     * @param region contains all of these parts.
     * @param maximumNodes the maximum number of steps of the search.
     * @return whether the layout has changed. */
    bool improve(Index anchor, int numParts, int seamCost, const LayoutRegion& region, int maximumNodes,
                 LayoutRandom& random);

    /** Replace the parts of two neighbouring cells and some parts near them, so that one part covers both cells, if
     * that connects components, separates no parts and costs at most `maximumCost` more.
     * @return whether the layout has changed. */
    bool join(Index cell, Index other, int numParts, const LayoutRegion& region, int maximumCost, LayoutRandom& random);

private:
    void gather(std::span<const Index> first, int numParts, const LayoutRegion& region, bool hasLayers,
                LayoutRandom& random);
    void addFrontier(Index anchor, const LayoutRegion& region, bool hasLayers);
    void apply();

    PartMap& _map;
    bool _hasBricks; //!< whether parts may be higher than one cell
    WindowBuilder _window;
    ExactCover _cover;
    ConnectionCheck _connections;
    std::vector<int> _chosen;
    std::vector<std::uint32_t> _seen; //!< for each anchor, the last window of which it was a neighbour or a part
    std::uint32_t _numGathered = 0;
    std::vector<Index> _frontier;
};

} // namespace osgLego
