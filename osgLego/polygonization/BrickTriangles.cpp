#include <osgLego/polygonization/BrickTriangles.h>

#include <osgLego/BrickDimensions.h>

#include <bit>

namespace osgLego
{

namespace
{

constexpr std::size_t SIDE_TRIANGLES = 2;
// The wall, and the disk as a fan.
constexpr std::size_t STUD_TRIANGLES = 3 * std::size_t{BrickDimensions::STUD_SIDES} - 2;

BrickSide upSideOf(const BrickGrid& grid)
{
    return static_cast<BrickSide>(SIDE_RIGHT << (2 * grid.getUpIndex()));
}

/** Find the open side with the given number, counted from 0 in the order of BrickSide. */
BrickSide findOpenSide(const Brick& brick, std::size_t number)
{
    unsigned int sides = brick.openSides;
    for (; number > 0; --number)
        sides &= sides - 1;
    return static_cast<BrickSide>(sides & -sides);
}

} // namespace

bool hasStud(const Brick& brick, const BrickGrid& grid)
{
    return (brick.openSides & upSideOf(grid)) != 0;
}

std::optional<BrickTriangle> findBrickTriangle(const BrickModel& model, std::size_t index)
{
    for (const Brick& brick : model.getBricks())
    {
        const std::size_t ofSides = SIDE_TRIANGLES * static_cast<std::size_t>(std::popcount(brick.openSides));
        if (index < ofSides) return BrickTriangle{brick, findOpenSide(brick, index / SIDE_TRIANGLES), false};
        index -= ofSides;
        if (!hasStud(brick, model.getGrid())) continue;
        if (index < STUD_TRIANGLES) return BrickTriangle{brick, upSideOf(model.getGrid()), true};
        index -= STUD_TRIANGLES;
    }
    return std::nullopt;
}

} // namespace osgLego
