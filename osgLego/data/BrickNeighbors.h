#pragma once

#include <osgLego/data/BrickPoints.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace osgLego
{

/** The covered cells around a brick, from which shaders compute its near occlusion (createOcclusionTable()), as 96
 * bits:
 *
 * - bits 0 to 11: the cells beside the twelve edges. Those beside the edges along axis e have the bits 4 * e + s + 2 *
 *   t, where s is 1 on the upper side along the axis after e, and t along the axis after that one; z is before x.
 * - bits 12 to 19: the cells at the corners, 12 + x + 2 * y + 4 * z, where 1 is the upper side.
 * - from bit 20 on, for each open side in the order of Brick::openSides: the second and the third layer of cells in
 *   front of it, 9 bits each, (u + 1) + 3 * (v + 1), where u and v are -1 to 1 along the two axes after that of the
 *   side. The first layer consists of cells beside edges and at corners. Bricks with five or six open sides have 9 bits
 *   for each, the second layer.
 *
 * Cells outside the grid count as empty. Bricks without open sides may count as either: no ray reaches them before
 * another brick. */
using BrickNeighbors = std::array<std::uint32_t, 3>;

/** The neighbours of each point. Its memory grows with the number of points, and not with the size of the grid. May be
 * called from any thread.
 * @param points all visible bricks, those of a block of BrickPoints consecutive. */
std::vector<BrickNeighbors> createBrickNeighbors(std::span<const BrickPoint> points);

} // namespace osgLego
