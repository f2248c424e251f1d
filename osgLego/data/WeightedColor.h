#pragma once

#include <osgLego/BrickModel.h>

#include <algorithm>

#include <glm/vec4.hpp>

namespace osgLego
{

/** The brick in a cell whose colours times weights, and weights, add up to `sum`; its open sides are not known yet.
 * May be called from any thread. */
inline Brick makeBrick(const glm::ivec3& cell, const glm::vec4& sum)
{
    // As std::lround, which is no function to be called for every cell.
    const auto toByte = [](float fraction)
    { return static_cast<std::uint8_t>(static_cast<double>(255.0f * std::clamp(fraction, 0.0f, 1.0f)) + 0.5); };
    Brick brick;
    brick.cell = {static_cast<std::uint16_t>(cell.x), static_cast<std::uint16_t>(cell.y),
                  static_cast<std::uint16_t>(cell.z)};
    brick.color = {toByte(sum.r / sum.a), toByte(sum.g / sum.a), toByte(sum.b / sum.a)};
    return brick;
}

} // namespace osgLego
