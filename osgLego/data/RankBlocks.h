#pragma once

#include <osgLego/BrickModel.h>

#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** When each cell of a model is put in place, for shaders that look cells up while the model is partly built.
 *
 * The first words are one for each block of BrickPoints::BLOCK_SIDE cells along each axis, x first, then y, then z:
 * where the ranks of the block's cells begin, in the same order; 0 for a block without cells. The rank of an empty
 * cell is CellRanks::NEVER. The memory grows with the number of blocks that have cells. May be called from any thread.
 * @param ranks for each part, its place in the order; for each brick of a model without parts. */
std::vector<std::uint32_t> createRankBlocks(const BrickModel& model, std::span<const std::uint32_t> ranks);

} // namespace osgLego
