#include <osgLego/layout/GreedyLayout.h>

#include <osgLego/PartType.h>
#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace osgLego
{

namespace
{

using Index = CellLattice::Index;

std::vector<std::array<int, 2>> getSizesByArea()
{
    std::vector<std::array<int, 2>> sizes(PART_SIZES.begin(), PART_SIZES.end());
    // Wide parts before narrow ones of equal area: they touch more parts below.
    std::sort(sizes.begin(), sizes.end(),
              [](const auto& a, const auto& b) { return std::pair(a[0] * a[1], a[0]) > std::pair(b[0] * b[1], b[0]); });
    return sizes;
}

/** Whether a part of a shape can be laid with its lowest corner on a cell. */
bool fits(const PartMap& map, const PartSizes& sizes, Index anchor, const PartShape& shape)
{
    const CellLattice& lattice = map.getLattice();
    std::uint16_t color = LayoutCell::ANY_COLOR;
    Index level = anchor;
    for (int dz = 0; dz < shape.height; ++dz)
    {
        Index row = level;
        for (int dy = 0; dy < shape.depth; ++dy)
        {
            Index cell = row;
            for (int dx = 0; dx < shape.width; ++dx)
            {
                if (cell == CellLattice::NONE || map.getAnchor(cell) != CellLattice::NONE) return false;
                const auto joint = PartSizes::join(color, lattice.getColor(cell));
                if (!joint) return false;
                color = *joint;
                if (dx + 1 < shape.width) cell = lattice.getNeighbor(cell, CellLattice::EAST);
            }
            if (dy + 1 < shape.depth) row = lattice.getNeighbor(row, CellLattice::NORTH);
        }
        if (dz + 1 < shape.height) level = lattice.getNeighbor(level, CellLattice::ABOVE);
    }
    return sizes.isAllowed(shape, color);
}

void layAll(PartMap& map, const PartSizes& sizes, Index begin, Index end, const PartShape& shape)
{
    for (Index cell = begin; cell < end; ++cell)
        if (map.getAnchor(cell) == CellLattice::NONE && fits(map, sizes, cell, shape)) map.lay(cell, shape);
}

/** Lay parts of one height whose lowest cells are in [begin, end). */
void layLayers(PartMap& map, const PartSizes& sizes, Index begin, Index end, int height)
{
    if (begin == end) return;
    const bool isAlongX = map.getLattice().getZ(begin) / height % 2 == 1;
    for (const auto& [shorter, longer] : getSizesByArea())
    {
        const auto width = static_cast<std::uint8_t>(isAlongX ? longer : shorter);
        const auto depth = static_cast<std::uint8_t>(isAlongX ? shorter : longer);
        const auto cells = static_cast<std::uint8_t>(height);
        layAll(map, sizes, begin, end, {width, depth, cells});
        if (shorter != longer) layAll(map, sizes, begin, end, {depth, width, cells});
    }
}

void layPlates(PartMap& map, const PartSizes& sizes)
{
    const CellLattice& lattice = map.getLattice();
    forEachIndex(static_cast<std::size_t>(lattice.getNumLayers()),
                 [&](std::size_t index)
                 {
                     const auto z = static_cast<int>(index);
                     layLayers(map, sizes, lattice.getLayerStart(z), lattice.getLayerStart(z + 1), 1);
                 });
}

/** Lay bricks of three layers each, from a layer on, and plates in the rest. Bricks at other heights would leave gaps
 * between each other. */
void layBricksAndPlates(PartMap& map, const PartSizes& sizes, int firstLayer)
{
    const CellLattice& lattice = map.getLattice();
    for (int z = firstLayer; z < lattice.getNumLayers(); z += PartSizes::BRICK_PLATES)
        layLayers(map, sizes, lattice.getLayerStart(z), lattice.getLayerStart(z + 1), PartSizes::BRICK_PLATES);
    layPlates(map, sizes);
}

} // namespace

void layGreedily(PartMap& map, const PartSizes& sizes)
{
    if (sizes.getHeights().size() == 1)
    {
        layPlates(map, sizes);
        return;
    }
    const PartMap start = map;
    for (int firstLayer = 0; firstLayer < PartSizes::BRICK_PLATES; ++firstLayer)
    {
        PartMap candidate = start;
        layBricksAndPlates(candidate, sizes, firstLayer);
        if (firstLayer == 0 || candidate.countParts() < map.countParts()) map.swap(candidate);
    }
}

} // namespace osgLego
