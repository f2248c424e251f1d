#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/BrickPoints.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace osgLego
{

/** When a cell and its neighbours are put in place: the ranks of their parts, in the order of building. A side is open
 * while the cell is in place and the neighbour on it is not. */
struct CellRanks
{
    /** The rank of a neighbour that does not exist: the side is always open. */
    static constexpr std::uint32_t NEVER = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t own = 0;
    /** On the lower sides of the axes; 0, the lowest rank, for a cell of the same part, whose side is never open. */
    std::array<std::uint32_t, 3> lower{NEVER, NEVER, NEVER};
    std::array<std::uint32_t, 3> upper{NEVER, NEVER, NEVER}; //!< likewise on the upper sides

    bool operator==(const CellRanks&) const = default;
};

/** The points of a model for drawing it partly built: every cell that has an open side at some time, block by block.
 *
 * The open sides of a point and of a block are all sides that are open at some time. */
struct BuildingPoints
{
    std::vector<BrickPoint> points; //!< sorted by z, y and x within a block
    std::vector<CellRanks> ranks;   //!< of the same cells
    /** As in BrickPoints; studs are those of cells whose upper side is ever open. */
    std::vector<BrickBlock> blocks;
};

/** The points of a model whose parts are put in place in a given order. May be called from any thread.
 * @param ranks for each part, its place in the order; for each brick of a model without parts. */
BuildingPoints createBuildingPoints(const BrickModel& model, std::span<const std::uint32_t> ranks);

} // namespace osgLego
