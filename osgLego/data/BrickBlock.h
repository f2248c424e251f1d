#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace osgLego
{

/** Bricks that lie together, in the grid and in the buffer that they are drawn from. */
struct BrickBlock
{
    int first = 0;              //!< the number of its first brick in the buffer
    int count = 0;              //!< how many bricks it has; they follow each other
    glm::ivec3 minimum{0};      //!< the lowest cell that any of them lies in, on each axis
    glm::ivec3 maximum{0};      //!< the highest, itself included
    std::uint8_t openSides = 0; //!< every side (BrickSide) that is open in any of them
};

} // namespace osgLego
