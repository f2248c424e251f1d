#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/BrickBlock.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** A brick as the shaders take it: x | y << 16, z | open sides << 16, and the colour, red in the lowest byte. */
using BrickPoint = std::array<std::uint32_t, 3>;

BrickPoint packBrick(const Brick& brick);
/** The cell and the open sides of a packed brick; the colour as well. */
Brick unpackBrick(const BrickPoint& point);

/** The bricks that can be seen, block by block. */
struct BrickPoints
{
    static constexpr int BLOCK_SIDE = 8; //!< of a block, in cells

    std::vector<BrickPoint> points;
    /** None is empty. In one place there may be two: bricks with studs, and bricks without. */
    std::vector<BrickBlock> blocks;
};

/** The points of a model's visible bricks; in a block they are sorted by z, y and x. May be called from any thread. */
BrickPoints createBrickPoints(const BrickModel& model);

/** The blocks of points of which those of a block follow each other. A block whose points stand in several places, as
 * at the border of two slabs, is several blocks. May be called from any thread. */
std::vector<BrickBlock> findBlocks(std::span<const BrickPoint> points);

} // namespace osgLego
