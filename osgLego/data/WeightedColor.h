#pragma once

#include <osgLego/BrickModel.h>

#include <algorithm>

#include <glm/vec4.hpp>

namespace osgLego
{

/** The brick in a cell, given the sum of its weighted colours (rgb) and the sum of the weights (a, above 0). Its open
 * sides are not set. May be called from any thread. */
inline Brick makeBrick(const glm::ivec3& cell, const glm::vec4& sum)
{
    // Rounds like std::lround, which is too slow to call for every cell.
    const auto toByte = [](float fraction)
    { return static_cast<std::uint8_t>(static_cast<double>(255.0f * std::clamp(fraction, 0.0f, 1.0f)) + 0.5); };
    Brick brick;
    brick.cell = {static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y),
                  static_cast<std::uint16_t>(cell.z)};
    brick.color = {toByte(sum.r / sum.a), toByte(sum.g / sum.a), toByte(sum.b / sum.a)};
    return brick;
}

} // namespace osgLego
