#include <osgLego/data/BrickPoints.h>

#include <algorithm>
#include <cstddef>
#include <span>

#include <glm/common.hpp>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

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

/** Sorts the bricks of one layer of blocks into blocks: first the bricks with studs, then the others. */
class BlockLayer
{
public:
    explicit BlockLayer(const BrickGrid& grid) :
        _stud(SIDE_RIGHT << (2 * grid.getUpIndex())),
        _width(static_cast<std::size_t>((grid.dimensions.x + SIDE - 1) / SIDE)),
        _size(_width * static_cast<std::size_t>((grid.dimensions.y + SIDE - 1) / SIDE)), _blocks(2 * _size)
    {
    }

    BrickPoints sort(std::span<const Brick> bricks)
    {
        for (const Brick& brick : bricks)
            if (brick.openSides != 0) include(brick, blockOf(brick));

        BrickPoints result;
        int next = 0;
        for (BrickBlock& block : _blocks)
        {
            if (block.count == 0) continue;
            block.first = next;
            next += block.count;
            result.blocks.push_back(block);
        }
        result.points.resize(static_cast<std::size_t>(next));
        for (const Brick& brick : bricks)
            if (brick.openSides != 0)
                result.points[static_cast<std::size_t>(blockOf(brick).first++)] = packBrick(brick);
        return result;
    }

private:
    BrickBlock& blockOf(const Brick& brick)
    {
        const std::size_t place =
            static_cast<std::size_t>(brick.cell[0] / SIDE) + _width * static_cast<std::size_t>(brick.cell[1] / SIDE);
        return _blocks[brick.openSides & _stud ? place : _size + place];
    }

    int _stud; // the side that has a stud when it is open
    std::size_t _width;
    std::size_t _size;
    std::vector<BrickBlock> _blocks; // including empty ones
};

/** The index of the first brick in each layer of blocks, followed by the number of all bricks. */
std::vector<std::size_t> findLayers(const std::vector<Brick>& bricks)
{
    std::vector<std::size_t> begins{0};
    for (int layer = SIDE; begins.back() < bricks.size(); layer += SIDE)
    {
        const auto end = std::partition_point(bricks.begin() + static_cast<std::ptrdiff_t>(begins.back()), bricks.end(),
                                              [layer](const Brick& brick) { return brick.cell[2] < layer; });
        begins.push_back(static_cast<std::size_t>(end - bricks.begin()));
    }
    return begins;
}

BrickPoints join(const std::vector<BrickPoints>& layers)
{
    BrickPoints result;
    std::size_t count = 0;
    for (const BrickPoints& layer : layers)
        count += layer.points.size();
    result.points.reserve(count);
    for (const BrickPoints& layer : layers)
    {
        for (BrickBlock block : layer.blocks)
        {
            block.first += static_cast<int>(result.points.size());
            result.blocks.push_back(block);
        }
        result.points.insert(result.points.end(), layer.points.begin(), layer.points.end());
    }
    return result;
}

} // namespace

BrickPoint packBrick(const Brick& brick)
{
    const auto& [red, green, blue] = brick.color;
    return {brick.cell[0] | std::uint32_t(brick.cell[1]) << 16, brick.cell[2] | std::uint32_t(brick.openSides) << 16,
            red | std::uint32_t(green) << 8 | std::uint32_t(blue) << 16 | std::uint32_t(0xff) << 24};
}

Brick unpackBrick(const BrickPoint& point)
{
    Brick brick;
    brick.cell = {static_cast<std::uint16_t>(point[0]), static_cast<std::uint16_t>(point[0] >> 16),
                  static_cast<std::uint16_t>(point[1])};
    brick.openSides = static_cast<std::uint8_t>(point[1] >> 16);
    brick.color = {static_cast<std::uint8_t>(point[2]), static_cast<std::uint8_t>(point[2] >> 8),
                   static_cast<std::uint8_t>(point[2] >> 16)};
    return brick;
}

std::vector<BrickBlock> findBlocks(std::span<const BrickPoint> points)
{
    std::vector<BrickBlock> blocks;
    glm::ivec3 last(-1);
    for (const BrickPoint& point : points)
    {
        const Brick brick = unpackBrick(point);
        const glm::ivec3 place = brick.getCell() / SIDE;
        if (place != last)
        {
            blocks.emplace_back();
            blocks.back().first = static_cast<int>(&point - points.data());
            last = place;
        }
        include(brick, blocks.back());
    }
    return blocks;
}

BrickPoints createBrickPoints(const BrickModel& model)
{
    const std::vector<Brick>& bricks = model.getBricks();
    const std::vector<std::size_t> begins = findLayers(bricks);
    std::vector<BrickPoints> layers(begins.size() - 1);
    const auto sortLayer = [&](std::size_t layer)
    {
        layers[layer] = BlockLayer(model.getGrid())
                            .sort(std::span(bricks).subspan(begins[layer], begins[layer + 1] - begins[layer]));
    };
    // Isolated: while it waits here, the thread must not run tasks of the caller, which may need locks that it holds.
    oneapi::tbb::this_task_arena::isolate([&] { oneapi::tbb::parallel_for(std::size_t(0), layers.size(), sortLayer); });
    return join(layers);
}

} // namespace osgLego
