#pragma once

#include <osgLego/data/UnionFind.h>
#include <osgLego/layout/PartMap.h>
#include <osgLego/search/LayoutRandom.h>
#include <osgLego/search/LayoutWindow.h>

#include <functional>
#include <utility>
#include <vector>

namespace osgLego
{

/** Joins two components of a layout at a time by a part that covers cells of both.
 *
 * One thread at a time. */
class ComponentJoiner
{
public:
    using Index = CellLattice::Index;

    ComponentJoiner(PartMap& map, const PartSizes& sizes);

    /** The maximum number of attempts. */
    struct Limits
    {
        int perPair = 0; //!< for each pair of neighbouring cells
        int total = 0;
    };

    /** Join as many components as possible.
     * @param isActive for each cell, whether it may be one of a pair, and parts that begin there may
     * change; empty: all cells may.
     * @return false if it was cancelled. */
    bool joinAll(const Limits& limits, const std::vector<bool>& isActive, LayoutRandom& random,
                 const std::function<bool()>& isCancelled);

private:
    using Pairs = std::vector<std::pair<Index, Index>>;

    Pairs findPairs(const std::vector<bool>& isActive);
    bool join(Index cell, Index other, const Limits& limits, const std::vector<bool>& isActive, LayoutRandom& random);

    PartMap& _map;
    LayoutWindow _window;
    UnionFind _components; //!< of cells
    int _numAttempts = 0;
};

} // namespace osgLego
