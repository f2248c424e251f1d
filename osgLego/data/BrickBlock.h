#pragma once

#include <osgLego/BrickModel.h>

#include <cstdint>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace osgLego
{

/** Bricks that are close together in the grid and consecutive in the buffer that they are drawn from. */
struct BrickBlock
{
    int first = 0;              //!< the index of its first brick in the buffer
    int count = 0;              //!< the number of its bricks
    glm::ivec3 minimum{0};      //!< the lowest coordinates of its cells
    glm::ivec3 maximum{0};      //!< the highest coordinates, inclusive
    std::uint8_t openSides = 0; //!< the sides (BrickSide bits) that are open in any of its bricks
    // Its bricks may be visible while firstRank < number of parts in place <= lastRank; see BuildingPoints.
    std::uint32_t firstRank = 0;
    std::uint32_t lastRank = std::numeric_limits<std::uint32_t>::max();

    /** Count a brick, and extend the block to its cell and sides. */
    void include(const Brick& brick)
    {
        const glm::ivec3 cell = brick.getCell();
        minimum = count == 0 ? cell : glm::min(minimum, cell);
        maximum = count == 0 ? cell : glm::max(maximum, cell);
        openSides |= brick.openSides;
        ++count;
    }
};

} // namespace osgLego
