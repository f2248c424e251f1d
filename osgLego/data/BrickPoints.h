#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/BrickBlock.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** A brick in the format of the shaders, in three words:
 *
 * - x | y << 16
 * - z | open sides << 16 | joined sides << 22 | length along x << 28 | length along the other horizontal axis << 30.
 *   A side is joined if the neighbour on it is of the same part (BrickSide bits). The lengths are those of the part, in
 *   cells: 0 for up to 2, 1 for 3, 2 for 4, 3 for more. Without a part, both are 0.
 * - the colour, red in the lowest byte, | number << 24. The number is pseudo-random, 0 to 254, and the same for all
 * cells of a part; NO_PART without a part. */
using BrickPoint = std::array<std::uint32_t, 3>;

constexpr std::uint32_t NO_PART = 255;

BrickPoint packBrick(const Brick& brick);
/** Likewise for a cell of a part. @param up the index of the up axis. */
BrickPoint packBrick(const Brick& brick, const Part& part, int up);
/** The inverse of packBrick(), without the part. */
Brick unpackBrick(const BrickPoint& point);

/** The visible bricks, block by block. */
struct BrickPoints
{
    static constexpr int BLOCK_SIDE = 8; //!< the edge length of a block, in cells

    std::vector<BrickPoint> points;
    /** None is empty. A part of the grid may have two blocks: one of bricks with studs, one of bricks without. */
    std::vector<BrickBlock> blocks;
};

/** The points of a model's visible bricks, sorted by z, y and x within a block. May be called from any thread. */
BrickPoints createBrickPoints(const BrickModel& model);

/** Divide points into blocks, given that the points of a block are consecutive. If they occur in several runs, as at
 * the border between two slabs, each run becomes a block. May be called from any thread. */
std::vector<BrickBlock> findBlocks(std::span<const BrickPoint> points);

} // namespace osgLego
