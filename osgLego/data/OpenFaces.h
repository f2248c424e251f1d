#pragma once

#include <osgLego/data/BrickPoints.h>

#include <span>

#include <glm/vec3.hpp>

namespace osgLego
{

constexpr int NUM_SIDES = 6; //!< of a brick, in the order of BrickSide

/** The step from a brick to the cell in front of a side. */
inline glm::ivec3 getSideNormal(int side)
{
    glm::ivec3 normal(0);
    normal[side / 2] = side % 2 == 0 ? -1 : 1;
    return normal;
}

/** Call `visit(cell, side)` for each open side of bricks, with the cell in front of it. */
template <typename Function>
void forEachOpenFace(std::span<const BrickPoint> points, const Function& visit)
{
    for (const BrickPoint& point : points)
    {
        const Brick brick = unpackBrick(point);
        for (int side = 0; side < NUM_SIDES; ++side)
            if (brick.openSides & 1 << side) visit(brick.getCell() + getSideNormal(side), side);
    }
}

} // namespace osgLego
