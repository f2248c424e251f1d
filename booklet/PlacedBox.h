#pragma once

#include <osgLego/BrickModel.h>

#include <glm/vec3.hpp>

namespace osgLego
{

/** A box of cells to the right, to the back and upwards from a place, whichever axis of its grid points upwards. */
struct PlacedBox
{
    glm::ivec3 lower{0};
    glm::ivec3 size{1};

    /** The cells of a part. */
    static PlacedBox create(const BrickGrid& grid, const Part& part)
    {
        const glm::ivec3 cell = part.getCell();
        const glm::ivec3 size = part.getSize();
        if (grid.upAxis == UpAxis::Z) return {cell, size};
        return {{cell.x, -cell.z - size.z, cell.y}, {size.x, size.z, size.y}}; // z points to the front
    }

    /** After quarter turns about the origin, counter-clockwise from above. @param turns 0 or more. */
    PlacedBox turn(int turns) const
    {
        PlacedBox turned = *this;
        for (int index = 0; index < turns; ++index)
            turned = {{-turned.lower.y - turned.size.y, turned.lower.x, turned.lower.z},
                      {turned.size.y, turned.size.x, turned.size.z}};
        return turned;
    }
};

} // namespace osgLego
