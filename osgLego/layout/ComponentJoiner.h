#pragma once

#include <osgLego/layout/LayoutRandom.h>
#include <osgLego/layout/LayoutWindow.h>
#include <osgLego/layout/PartMap.h>
#include <osgLego/layout/UnionFind.h>

#include <functional>
#include <utility>
#include <vector>

namespace osgLego
{

/** Joins components of a layout by parts that cover cells of both.
 *
 * One thread at a time. */
class ComponentJoiner
{
public:
    using Index = CellLattice::Index;

    ComponentJoiner(PartMap& map, const PartSizes& sizes);

    /** Join as many components as possible.
     * @param numAttempts for each pair of neighbouring cells.
     * @return false if it was cancelled. */
    bool joinAll(int numAttempts, LayoutRandom& random, const std::function<bool()>& isCancelled);

private:
    using Pairs = std::vector<std::pair<Index, Index>>;

    void findComponents();
    Pairs findPairs() const;
    bool join(Index cell, Index other, int numAttempts, LayoutRandom& random);

    PartMap& _map;
    LayoutWindow _window;
    mutable UnionFind _components; //!< of cells
};

} // namespace osgLego
