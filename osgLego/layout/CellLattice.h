#pragma once

#include <osgLego/layout/LayoutProblem.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgLego
{

/** The cells of a layout and their neighbours. A cell is named by its index in LayoutProblem::cells, so that cells in a
 * row have consecutive indices, and the least index of a part is that of its lowest corner.
 *
 * Immutable; may be used from any thread while the problem exists. */
class CellLattice
{
public:
    using Index = std::int32_t;
    static constexpr Index NONE = -1;

    enum Side : std::uint8_t
    {
        EAST,  //!< towards +x
        WEST,  //!< towards -x
        NORTH, //!< towards +y
        SOUTH, //!< towards -y
        ABOVE, //!< towards +z
        BELOW  //!< towards -z
    };
    static constexpr std::array<Side, 4> LEVEL_SIDES{EAST, WEST, NORTH, SOUTH};

    /** Whether a side of LEVEL_SIDES is along x, not along y. */
    static constexpr bool isAlongX(Side side) { return side == EAST || side == WEST; }

    explicit CellLattice(const LayoutProblem& problem);

    const LayoutProblem& getProblem() const { return _problem; }
    Index getNumCells() const { return static_cast<Index>(_problem.cells.size()); }
    int getNumLayers() const { return static_cast<int>(_layerStarts.size()) - 1; }
    /** The first cell at height z or above; z is in [0, getNumLayers()]. */
    Index getLayerStart(int z) const { return _layerStarts[static_cast<std::size_t>(z)]; }

    int getX(Index cell) const { return get(cell).place[0]; }
    int getY(Index cell) const { return get(cell).place[1]; }
    int getZ(Index cell) const { return get(cell).place[2]; }
    std::uint16_t getColor(Index cell) const { return get(cell).color; }
    /** The cell beside a cell, or NONE. */
    Index getNeighbor(Index cell, Side side) const { return _neighbors[static_cast<std::size_t>(cell)][side]; }
    /** Whether there is a cell directly above or below a cell, so that every layout connects its part to another,
     * unless one part covers both. */
    bool isInColumn(Index cell) const { return getNeighbor(cell, ABOVE) != NONE || getNeighbor(cell, BELOW) != NONE; }
    /** The cell at a number of steps from a cell, or NONE if there is no cell there or on the way. Returns NONE for
     * NONE. */
    Index move(Index cell, Side side, int steps) const
    {
        for (; steps > 0 && cell != NONE; --steps)
            cell = getNeighbor(cell, side);
        return cell;
    }

private:
    const LayoutCell& get(Index cell) const { return _problem.cells[static_cast<std::size_t>(cell)]; }
    void link(const std::array<int, 3>& step, Side side, Side opposite);

    const LayoutProblem& _problem;
    std::vector<Index> _layerStarts;
    std::vector<std::array<Index, 6>> _neighbors;
};

} // namespace osgLego
