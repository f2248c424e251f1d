#include <osgLego/layout/GreedyLayout.h>

#include <osgLego/PartType.h>
#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

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

/** Whether a brick is a component of its own, as there are no cells above or below it, while plates in its place may
 * reach cells beside it. @param color of the brick. */
bool isolates(const PartMap& map, Index anchor, const PartShape& shape, std::uint16_t color)
{
    const CellLattice& lattice = map.getLattice();
    const std::array<int, 3> first{lattice.getX(anchor), lattice.getY(anchor), lattice.getZ(anchor)};
    const auto isInside = [&](Index cell)
    {
        const int x = lattice.getX(cell) - first[0];
        const int y = lattice.getY(cell) - first[1];
        const int z = lattice.getZ(cell) - first[2];
        return x >= 0 && x < shape.width && y >= 0 && y < shape.depth && z >= 0 && z < shape.height;
    };
    bool isInColumn = false;
    bool isBesideOthers = false;
    map.visitCells(anchor, shape,
                   [&](Index cell)
                   {
                       for (const CellLattice::Side side : {CellLattice::ABOVE, CellLattice::BELOW})
                       {
                           const Index other = lattice.getNeighbor(cell, side);
                           isInColumn = isInColumn || (other != CellLattice::NONE && !isInside(other));
                       }
                       for (const CellLattice::Side side : CellLattice::LEVEL_SIDES)
                       {
                           const Index other = lattice.getNeighbor(cell, side);
                           isBesideOthers = isBesideOthers || (other != CellLattice::NONE && !isInside(other) &&
                                                               PartSizes::join(color, lattice.getColor(other)));
                       }
                   });
    return !isInColumn && isBesideOthers;
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
    return sizes.isAllowed(shape, color) && (shape.height == 1 || !isolates(map, anchor, shape, color));
}

/** The number of cells in a row from a cell on, itself included, up to the length of the longest part. */
struct RowLengths
{
    std::uint8_t east = 0;
    std::uint8_t north = 0;
};

/** Find the rows of columns of a height whose lowest cells have colours that one part may cover: most parts that don't
 * fit are longer than these rows. */
std::vector<RowLengths> findRows(const CellLattice& lattice, int height)
{
    std::vector<RowLengths> rows(static_cast<std::size_t>(lattice.getNumCells()));
    const auto extend = [&](Index cell, CellLattice::Side side, std::uint8_t RowLengths::*length)
    {
        std::uint8_t& own = rows[static_cast<std::size_t>(cell)].*length;
        own = 1;
        const Index other = lattice.getNeighbor(cell, side);
        if (other == CellLattice::NONE || !PartSizes::join(lattice.getColor(cell), lattice.getColor(other))) return;
        own = static_cast<std::uint8_t>(
            std::min(rows[static_cast<std::size_t>(other)].*length + 1, int{PartSizes::LONGEST}));
    };
    for (Index cell = lattice.getNumCells(); cell-- > 0;)
        if (lattice.move(cell, CellLattice::ABOVE, height - 1) != CellLattice::NONE)
        {
            extend(cell, CellLattice::EAST, &RowLengths::east);
            extend(cell, CellLattice::NORTH, &RowLengths::north);
        }
    return rows;
}

/** Lay parts of a shape on cells, where they fit. */
void layAll(PartMap& map, const PartSizes& sizes, const std::vector<RowLengths>& rows, const std::vector<Index>& cells,
            const PartShape& shape)
{
    for (const Index cell : cells)
    {
        const RowLengths& row = rows[static_cast<std::size_t>(cell)];
        if (row.east >= shape.width && row.north >= shape.depth && map.getAnchor(cell) == CellLattice::NONE &&
            fits(map, sizes, cell, shape))
            map.lay(cell, shape);
    }
}

/** Lay parts of one height whose lowest cells are in [begin, end).
 * @param rows those of columns of this height. */
void layLayers(PartMap& map, const PartSizes& sizes, const std::vector<RowLengths>& rows, Index begin, Index end,
               int height)
{
    if (begin == end) return;
    const auto isCovered = [&map](Index cell) { return map.getAnchor(cell) != CellLattice::NONE; };
    std::vector<Index> cells;
    for (Index cell = begin; cell < end; ++cell)
        if (rows[static_cast<std::size_t>(cell)].east > 0 && !isCovered(cell)) cells.push_back(cell);
    const bool isAlongX = map.getLattice().getZ(begin) / height % 2 == 1;
    for (const auto& [shorter, longer] : getSizesByArea())
    {
        const auto width = static_cast<std::uint8_t>(isAlongX ? longer : shorter);
        const auto depth = static_cast<std::uint8_t>(isAlongX ? shorter : longer);
        const auto numLayers = static_cast<std::uint8_t>(height);
        layAll(map, sizes, rows, cells, {width, depth, numLayers});
        if (shorter != longer) layAll(map, sizes, rows, cells, {depth, width, numLayers});
        std::erase_if(cells, isCovered);
    }
}

void layPlates(PartMap& map, const PartSizes& sizes, const std::vector<RowLengths>& rows)
{
    const CellLattice& lattice = map.getLattice();
    forEachIndex(static_cast<std::size_t>(lattice.getNumLayers()),
                 [&](std::size_t index)
                 {
                     const auto z = static_cast<int>(index);
                     layLayers(map, sizes, rows, lattice.getLayerStart(z), lattice.getLayerStart(z + 1), 1);
                 });
}

/** Lay bricks of three layers each, from a layer on, and plates in the rest. Bricks at other heights would leave gaps
 * between each other. */
void layBricksAndPlates(PartMap& map, const PartSizes& sizes, const std::vector<RowLengths>& rowsOfBricks,
                        const std::vector<RowLengths>& rowsOfPlates, int firstLayer)
{
    const CellLattice& lattice = map.getLattice();
    const auto numLayers = static_cast<std::size_t>(std::max(lattice.getNumLayers() - firstLayer, 0));
    forEachIndex((numLayers + PartSizes::BRICK_PLATES - 1) / PartSizes::BRICK_PLATES,
                 [&](std::size_t index)
                 {
                     const int z = firstLayer + static_cast<int>(index) * PartSizes::BRICK_PLATES;
                     layLayers(map, sizes, rowsOfBricks, lattice.getLayerStart(z), lattice.getLayerStart(z + 1),
                               PartSizes::BRICK_PLATES);
                 });
    layPlates(map, sizes, rowsOfPlates);
}

} // namespace

void layGreedily(PartMap& map, const PartSizes& sizes)
{
    const std::vector<RowLengths> rowsOfPlates = findRows(map.getLattice(), 1);
    if (sizes.getHeights().size() == 1)
    {
        layPlates(map, sizes, rowsOfPlates);
        return;
    }
    const std::vector<RowLengths> rowsOfBricks = findRows(map.getLattice(), PartSizes::BRICK_PLATES);
    const PartMap start = map;
    for (int firstLayer = 0; firstLayer < PartSizes::BRICK_PLATES; ++firstLayer)
    {
        PartMap candidate = start;
        layBricksAndPlates(candidate, sizes, rowsOfBricks, rowsOfPlates, firstLayer);
        if (firstLayer == 0 || candidate.countParts() < map.countParts()) map.swap(candidate);
    }
}

} // namespace osgLego
