#pragma once

#include <osgLego/data/UnionFind.h>
#include <osgLego/search/PartCut.h>

#include <array>
#include <vector>

namespace osgLego
{

/** Finds bridges: parts that join two components of a layout if they are laid over others, without separating any.
 *
 * Keeps its memory from one search to the next. One thread at a time. */
class BridgeFinder
{
public:
    using Index = CellLattice::Index;
    using Piece = PartCut::Piece;

    /** @param components sets of cells; cells above each other are in one set. */
    BridgeFinder(const PartMap& map, const PartSizes& sizes, UnionFind& components) :
        _map(map), _sizes(sizes), _components(components), _cut(map, sizes)
    {
    }

    /** Find the bridge that contains a cell and its neighbour to the east or to the north, and adds the fewest parts.
     * @return the bridge and the strips that remain of the parts that it cuts, to be laid; empty if there is none. */
    const std::vector<Piece>& find(Index cell, CellLattice::Side side, const LayoutRegion& region);

private:
    struct Candidate
    {
        Piece bridge;
        int numAdded = 0; //!< parts
    };

    void findParts(Index cell, CellLattice::Side side, int height, const LayoutRegion& region);
    void findBricks(Index cell, CellLattice::Side side, const LayoutRegion& region);
    void tryAt(Index cell, const std::array<int, 2>& offset, const PartShape& shape, const LayoutRegion& region);

    const PartMap& _map;
    const PartSizes& _sizes;
    UnionFind& _components;
    PartCut _cut;
    std::vector<Candidate> _candidates;
};

} // namespace osgLego
