#include <osgLego/layout/ReachingParts.h>

#include <osgLego/PartType.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego
{

namespace
{

using Index = CellLattice::Index;

constexpr int LEAST_DISTANCE = 3; // cells; nearer ones are easy to reach

/** The cells between columns, each two or more cells above each other. */
class FlatPlaces
{
public:
    FlatPlaces(PartMap& map, const PartSizes& sizes) :
        _map(map), _sizes(sizes), _lattice(map.getLattice()),
        _distances(static_cast<std::size_t>(_lattice.getNumCells()), UNKNOWN)
    {
    }

    void lay()
    {
        const std::vector<Index> cells = findDistances();
        for (auto cell = cells.rbegin(); cell != cells.rend() && distanceOf(*cell) >= LEAST_DISTANCE; ++cell)
            if (_map.getAnchor(*cell) == CellLattice::NONE) layOn(*cell);
    }

private:
    static constexpr std::uint8_t UNKNOWN = 255;

    std::uint8_t& distanceOf(Index cell) { return _distances[static_cast<std::size_t>(cell)]; }

    /** Find the distance of each cell from the nearest one in a column, in steps from side to side.
     * @return the cells outside columns, by their distance. */
    std::vector<Index> findDistances()
    {
        std::vector<Index> reached;
        for (Index cell = 0; cell < _lattice.getNumCells(); ++cell)
            if (_lattice.isInColumn(cell)) distanceOf(cell) = 0;
        for (Index cell = 0; cell < _lattice.getNumCells(); ++cell)
            if (distanceOf(cell) == 0) reachFrom(cell, reached);
        for (std::size_t i = 0; i < reached.size(); ++i)
            reachFrom(reached[i], reached);
        return reached;
    }

    void reachFrom(Index cell, std::vector<Index>& reached)
    {
        // Cells farther away than the length of a part need no exact distance.
        const auto distance = static_cast<std::uint8_t>(std::min<int>(distanceOf(cell) + 1, 2 * PartSizes::LONGEST));
        for (const auto side : CellLattice::LEVEL_SIDES)
        {
            const Index other = _lattice.getNeighbor(cell, side);
            if (other == CellLattice::NONE || distanceOf(other) != UNKNOWN) continue;
            if (!PartSizes::join(_lattice.getColor(cell), _lattice.getColor(other))) continue;
            distanceOf(other) = distance;
            reached.push_back(other);
        }
    }

    /** Lay the part that contains a cell and one in a column, and that covers the most distances. */
    void layOn(Index cell)
    {
        _bestSum = 0;
        for (const auto& [shorter, longer] : PART_SIZES)
        {
            if (longer <= distanceOf(cell)) continue;
            tryAll(cell, {static_cast<std::uint8_t>(longer), static_cast<std::uint8_t>(shorter), 1});
            tryAll(cell, {static_cast<std::uint8_t>(shorter), static_cast<std::uint8_t>(longer), 1});
        }
        if (_bestSum > 0) _map.lay(_best, _bestShape);
    }

    void tryAll(Index cell, const PartShape& shape)
    {
        Index column = cell;
        for (int x = 0; x < shape.width && column != CellLattice::NONE; ++x)
        {
            Index anchor = column;
            for (int y = 0; y < shape.depth && anchor != CellLattice::NONE; ++y)
            {
                if (const int sum = sumDistances(anchor, shape); sum > _bestSum)
                {
                    _bestSum = sum;
                    _best = anchor;
                    _bestShape = shape;
                }
                anchor = _lattice.getNeighbor(anchor, CellLattice::SOUTH);
            }
            column = _lattice.getNeighbor(column, CellLattice::WEST);
        }
    }

    /** The sum of the distances of the cells of a part; 0 if it can't be laid or contains no cell in a column. */
    int sumDistances(Index anchor, const PartShape& shape)
    {
        std::uint16_t color = LayoutCell::ANY_COLOR;
        bool hasColumn = false;
        int sum = 0;
        Index row = anchor;
        for (int y = 0; y < shape.depth; ++y, row = _lattice.move(row, CellLattice::NORTH, 1))
        {
            Index cell = row;
            for (int x = 0; x < shape.width; ++x, cell = _lattice.move(cell, CellLattice::EAST, 1))
            {
                if (cell == CellLattice::NONE || _map.getAnchor(cell) != CellLattice::NONE) return 0;
                const auto joint = PartSizes::join(color, _lattice.getColor(cell));
                if (!joint) return 0;
                color = *joint;
                hasColumn |= distanceOf(cell) == 0;
                sum += std::min<int>(distanceOf(cell), PartSizes::LONGEST);
            }
        }
        return hasColumn && _sizes.isMade(shape, color) ? sum : 0;
    }

    PartMap& _map;
    const PartSizes& _sizes;
    const CellLattice& _lattice;
    std::vector<std::uint8_t> _distances;
    Index _best = CellLattice::NONE;
    PartShape _bestShape;
    int _bestSum = 0;
};

} // namespace

void layReachingParts(PartMap& map, const PartSizes& sizes)
{
    FlatPlaces(map, sizes).lay();
}

} // namespace osgLego
