#pragma once

#include <osgLego/layout/PartMap.h>

#include <cstddef>
#include <vector>

namespace osgLego
{

/** The cells in which one thread changes parts, and margins around them that no thread changes at the same time. */
struct LayoutRegion
{
    int zBegin = 0;
    int zEnd = 0;
    int yBegin = 0;
    int yEnd = 0;
    int zMargin = 0; //!< layers above and below that may be read
    int yMargin = 0; //!< rows on both sides that may be read
    /** For each anchor of a part that no thread changes, the anchor that stands for its component of such parts; NONE
     * for other cells. */
    const std::vector<CellLattice::Index>* fixedComponents = nullptr;
    /** For each cell, whether a part that begins there may change; null or empty: all may. */
    const std::vector<bool>* activeCells = nullptr;

    /** Whether a cell of the region's layers is in its rows. Threads may change the others at the same time. */
    bool hasRowOf(const CellLattice& lattice, CellLattice::Index cell) const
    {
        const int y = lattice.getY(cell);
        return y >= yBegin && y < yEnd;
    }
    /** Whether a part lies inside. */
    bool contains(const PartMap& map, CellLattice::Index anchor) const
    {
        const CellLattice& lattice = map.getLattice();
        const PartShape& shape = map.getShape(anchor);
        const int y = lattice.getY(anchor);
        const int z = lattice.getZ(anchor);
        return z >= zBegin && z + shape.height <= zEnd && y >= yBegin && y + shape.depth <= yEnd;
    }
    /** Whether a part may change. */
    bool isActive(CellLattice::Index anchor) const
    {
        return !activeCells || activeCells->empty() || (*activeCells)[static_cast<std::size_t>(anchor)];
    }
    /** Whether the part that covers a cell may be read. */
    bool isReadable(const CellLattice& lattice, CellLattice::Index cell) const
    {
        const int y = lattice.getY(cell);
        const int z = lattice.getZ(cell);
        return z >= zBegin - zMargin && z < zEnd + zMargin && y >= yBegin - yMargin && y < yEnd + yMargin;
    }
};

} // namespace osgLego
