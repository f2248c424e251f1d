#pragma once

#include <osgLego/layout/PartMap.h>

namespace osgLego
{

/** The cells whose parts one thread changes, and the cells around them that no thread changes meanwhile. */
struct LayoutRegion
{
    int zBegin = 0;
    int zEnd = 0;
    int yBegin = 0;
    int yEnd = 0;
    int margin = 0; //!< layers above and below that may be read

    /** Whether a part lies inside. */
    bool contains(const PartMap& map, CellLattice::Index anchor) const
    {
        const CellLattice& lattice = map.getLattice();
        const PartShape& shape = map.getShape(anchor);
        const int y = lattice.getY(anchor);
        const int z = lattice.getZ(anchor);
        return z >= zBegin && z + shape.height <= zEnd && y >= yBegin && y + shape.depth <= yEnd;
    }
    /** Whether the part of a cell may be read. */
    bool isReadable(const CellLattice& lattice, CellLattice::Index cell) const
    {
        const int z = lattice.getZ(cell);
        return z >= zBegin - margin && z < zEnd + margin;
    }
};

} // namespace osgLego
