#pragma once

#include <osgLego/data/UnionFind.h>
#include <osgLego/layout/PartMap.h>
#include <osgLego/search/BridgeFinder.h>
#include <osgLego/search/LayoutRandom.h>
#include <osgLego/search/LayoutWindow.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace osgLego
{

/** Joins components of a layout by bridges: parts across the seams between them (BridgeFinder).
 *
 * Much faster than ComponentJoiner, but finds only joins that change few parts and separate none.
 *
 * One thread at a time. */
class BridgeJoiner
{
public:
    using Index = CellLattice::Index;

    BridgeJoiner(PartMap& map, const PartSizes& sizes);

    /** Join components, the smallest first.
     * @param isActive for each cell, whether it may be at a seam, and parts that begin there may change; empty: all
     * cells may.
     * @return false if it was cancelled. */
    bool joinAll(const std::vector<bool>& isActive, LayoutRandom& random, const std::function<bool()>& isCancelled);

private:
    /** Two neighbouring cells in different components. */
    struct Seam
    {
        std::int32_t numCells = 0; //!< of the smaller component
        Index component = CellLattice::NONE;
        Index cell = CellLattice::NONE;
        CellLattice::Side side = CellLattice::EAST;
    };

    void findComponents();
    void findSeams(const std::vector<bool>& isActive, LayoutRandom& random);
    void addSeam(Index cell, CellLattice::Side side);
    bool join(const Seam& seam, const LayoutRegion& region, LayoutRandom& random);
    bool joinAlone(Index anchor, const LayoutRegion& region, LayoutRandom& random);
    bool isReachable(Index anchor) const;
    bool isNearColumn(Index cell) const;
    void layAll(const std::vector<PartCut::Piece>& pieces, const LayoutRegion& region);
    void merge(Index anchor, const LayoutRegion& region);
    Index findAligned(Index anchor, CellLattice::Side side) const;
    void noteContacts(Index anchor);

    PartMap& _map;
    const PartSizes& _sizes;
    LayoutWindow _window;
    UnionFind _components; //!< of cells
    BridgeFinder _finder;
    std::vector<Seam> _seams;
    std::vector<std::int32_t> _numCells; //!< of each component
};

} // namespace osgLego
