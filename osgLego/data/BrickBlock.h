#pragma once

#include <cstdint>

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
};

} // namespace osgLego
