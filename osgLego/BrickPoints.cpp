#include <osgLego/BrickPoints.h>

#include <algorithm>
#include <span>

#include <glm/common.hpp>

namespace osgLego
{

namespace
{

constexpr int SIDE = BrickPoints::BLOCK_SIDE;

void include(const Brick& brick, BrickBlock& block)
{
    const glm::ivec3 cell = brick.getCell();
    block.minimum = block.count == 0 ? cell : glm::min(block.minimum, cell);
    block.maximum = block.count == 0 ? cell : glm::max(block.maximum, cell);
    block.openSides |= brick.openSides;
    ++block.count;
}

/** Appends the bricks of one layer of blocks after the other: those with studs, then the others. */
class BlockLayers
{
public:
    BlockLayers(const BrickGrid& grid, BrickPoints& result) :
        _stud(SIDE_RIGHT << (2 * grid.getUpIndex())),
        _width(static_cast<std::size_t>((grid.dimensions.x + SIDE - 1) / SIDE)),
        _size(_width * static_cast<std::size_t>((grid.dimensions.y + SIDE - 1) / SIDE)), _blocks(2 * _size),
        _result(result)
    {
    }

    void append(std::span<const Brick> bricks)
    {
        std::fill(_blocks.begin(), _blocks.end(), BrickBlock());
        for (const Brick& brick : bricks)
            if (brick.openSides != 0) include(brick, blockOf(brick));

        std::size_t next = _result.points.size();
        for (BrickBlock& block : _blocks)
        {
            if (block.count == 0) continue;
            block.first = static_cast<int>(next);
            next += static_cast<std::size_t>(block.count);
            _result.blocks.push_back(block);
        }
        _result.points.resize(next);
        for (const Brick& brick : bricks)
            if (brick.openSides != 0)
                _result.points[static_cast<std::size_t>(blockOf(brick).first++)] = packBrick(brick);
    }

private:
    BrickBlock& blockOf(const Brick& brick)
    {
        const std::size_t place =
            static_cast<std::size_t>(brick.cell[0] / SIDE) + _width * static_cast<std::size_t>(brick.cell[1] / SIDE);
        return _blocks[brick.openSides & _stud ? place : _size + place];
    }

    int _stud; // the side that has one when it is open
    std::size_t _width;
    std::size_t _size;
    std::vector<BrickBlock> _blocks; // of one layer, with and without bricks
    BrickPoints& _result;
};

} // namespace

BrickPoint packBrick(const Brick& brick)
{
    const auto& [red, green, blue] = brick.color;
    return {brick.cell[0] | std::uint32_t(brick.cell[1]) << 16, brick.cell[2] | std::uint32_t(brick.openSides) << 16,
            red | std::uint32_t(green) << 8 | std::uint32_t(blue) << 16 | std::uint32_t(0xff) << 24};
}

BrickPoints createBrickPoints(const BrickModel& model)
{
    BrickPoints result;
    result.points.reserve(model.getBricks().size());
    BlockLayers layers(model.getGrid(), result);
    auto begin = model.getBricks().begin();
    for (int layer = SIDE; begin != model.getBricks().end(); layer += SIDE)
    {
        const auto end = std::partition_point(begin, model.getBricks().end(),
                                              [layer](const Brick& brick) { return brick.cell[2] < layer; });
        layers.append({begin, end});
        begin = end;
    }
    return result;
}

} // namespace osgLego
