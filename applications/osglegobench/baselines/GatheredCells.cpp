#include "GatheredCells.h"

namespace osgLego
{

namespace
{

constexpr std::uint32_t LOW_HALF = 0xffff;

glm::ivec3 cellOf(const BrickPoint& point)
{
    return {static_cast<int>(point[0] & LOW_HALF), static_cast<int>(point[0] >> 16),
            static_cast<int>(point[1] & LOW_HALF)};
}

} // namespace

void GatheredCells::reset(const glm::ivec3& dimensions)
{
    _rowLength = static_cast<std::size_t>(dimensions.x + 2);
    _layerLength = _rowLength * static_cast<std::size_t>(dimensions.y + 2);
    _words.assign(_layerLength * static_cast<std::size_t>(dimensions.z + 2) / 64 + 1, 0);
    _bricks.clear();
}

std::uint32_t GatheredCells::findOpenSides(const BrickPoint& brick) const
{
    const std::size_t number = numberOf(cellOf(brick));
    std::uint32_t sides = 0;
    if (isEmpty(number - 1)) sides |= SIDE_LEFT;
    if (isEmpty(number + 1)) sides |= SIDE_RIGHT;
    if (isEmpty(number - _rowLength)) sides |= SIDE_FRONT;
    if (isEmpty(number + _rowLength)) sides |= SIDE_BACK;
    if (isEmpty(number - _layerLength)) sides |= SIDE_BOTTOM;
    if (isEmpty(number + _layerLength)) sides |= SIDE_TOP;
    return sides;
}

const std::vector<BrickPoint>& GatheredCells::findVisible()
{
    _visible.clear();
    _visible.reserve(_bricks.size());
    for (const BrickPoint& brick : _bricks)
        if (const std::uint32_t sides = findOpenSides(brick))
            _visible.push_back({brick[0], brick[1] | sides << 16, brick[2]});
    return _visible;
}

osg::ref_ptr<const BrickModel> createModel(const BrickGrid& grid, const std::vector<BrickPoint>& points)
{
    std::vector<Brick> bricks;
    bricks.reserve(points.size());
    for (const BrickPoint& point : points)
    {
        const glm::ivec3 cell = cellOf(point);
        Brick brick;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            brick.cell[axis] = static_cast<std::uint16_t>(cell[static_cast<int>(axis)]);
            brick.color[axis] = static_cast<std::uint8_t>(point[2] >> 8 * axis);
        }
        bricks.push_back(brick);
    }
    return BrickModel::create(grid, std::move(bricks));
}

} // namespace osgLego
