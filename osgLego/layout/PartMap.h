#pragma once

#include <osgLego/data/UnionFind.h>
#include <osgLego/layout/CellLattice.h>
#include <osgLego/layout/PartSizes.h>

#include <cstddef>
#include <vector>

namespace osgLego
{

/** A layout while it is computed: the part of each cell. A part is named by its anchor, its cell of the least index.
 *
 * Several threads may change it at once where they read and write different cells. */
class PartMap
{
public:
    using Index = CellLattice::Index;

    explicit PartMap(const CellLattice& lattice);

    const CellLattice& getLattice() const { return _lattice; }
    /** The anchor of a cell's part; NONE if no part covers it. */
    Index getAnchor(Index cell) const { return _anchors[static_cast<std::size_t>(cell)]; }
    bool isAnchor(Index cell) const { return getAnchor(cell) == cell; }
    const PartShape& getShape(Index anchor) const { return _shapes[static_cast<std::size_t>(anchor)]; }
    /** LayoutCell::ANY_COLOR if all its cells have that. */
    std::uint16_t getColor(Index anchor) const;
    /** Whether a part touches no other part above or below. */
    bool isAlone(Index anchor) const;
    Index countParts() const;
    /** Find the components of a layout that covers all cells: sets of cells that are in one part or above each other.
     */
    void findComponents(UnionFind& components) const;

    /** Exchange the parts with those of a layout of the same cells. */
    void swap(PartMap& other);

    /** Cover the cells of a box with a part. All of them must exist. */
    void lay(Index anchor, const PartShape& shape);
    /** Uncover the cells of a part. */
    void remove(Index anchor);

    /** Call visit(cell) for each cell of the box of this shape at `anchor`, all of which must exist. */
    template <typename Visit>
    void visitCells(Index anchor, const PartShape& shape, Visit visit) const
    {
        for (int dz = 0; dz < shape.height; ++dz)
        {
            Index row = anchor;
            for (int dy = 0; dy < shape.depth; ++dy)
            {
                for (int dx = 0; dx < shape.width; ++dx)
                    visit(row + dx);
                if (dy + 1 < shape.depth) row = _lattice.getNeighbor(row, CellLattice::NORTH);
            }
            if (dz + 1 < shape.height) anchor = _lattice.getNeighbor(anchor, CellLattice::ABOVE);
        }
    }

    /** Call visit(cell) for each cell of a part. */
    template <typename Visit>
    void visitPart(Index anchor, Visit visit) const
    {
        visitCells(anchor, getShape(anchor), visit);
    }

private:
    const CellLattice& _lattice;
    std::vector<Index> _anchors;
    std::vector<PartShape> _shapes; //!< valid for anchors
};

} // namespace osgLego
