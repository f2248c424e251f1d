#pragma once

#include <osgLego/BrickModel.h>
#include <osgLego/data/BrickBlock.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** A brick in the format of the shaders: x | y << 16, z | open sides << 16, and the colour, red in the lowest byte. */
using BrickPoint = std::array<std::uint32_t, 3>;

BrickPoint packBrick(const Brick& brick);
/** The inverse of packBrick(). */
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
