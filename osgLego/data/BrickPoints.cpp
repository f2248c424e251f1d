#include <osgLego/data/BrickPoints.h>

#include <osgLego/data/ParallelLoop.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace osgLego
{

namespace
{

constexpr int SIDE = BrickPoints::BLOCK_SIDE;

/** Numbers the blocks of one layer of blocks, row by row. Memory follows the number of bricks, not the size of the
 * grid. */
class BlockNumbers
{
public:
    explicit BlockNumbers(std::span<const Brick> bricks)
    {
        glm::ivec2 last(-1);
        for (const Brick& brick : bricks)
        {
            const glm::ivec2 place = placeOf(brick);
            _first = glm::min(_first, place);
            last = glm::max(last, place);
        }
        const glm::ivec2 size = glm::max(last - _first + 1, 0);
        _width = static_cast<std::size_t>(size.x);
        _count = _width * static_cast<std::size_t>(size.y);
        if (_count > MOST_PER_BRICK * bricks.size()) list(bricks);
    }

    std::size_t getCount() const { return _count; }

    std::size_t find(const Brick& brick) const
    {
        const std::size_t key = keyOf(brick);
        if (_keys.empty()) return key;
        return static_cast<std::size_t>(std::lower_bound(_keys.begin(), _keys.end(), key) - _keys.begin());
    }

private:
    static constexpr std::size_t MOST_PER_BRICK = 4; // a search takes longer than a look into a table

    static glm::ivec2 placeOf(const Brick& brick) { return glm::ivec2(brick.cell[0], brick.cell[1]) / SIDE; }

    std::size_t keyOf(const Brick& brick) const
    {
        const glm::ivec2 place = placeOf(brick) - _first;
        return static_cast<std::size_t>(place.x) + _width * static_cast<std::size_t>(place.y);
    }

    /** Number only blocks with bricks. */
    void list(std::span<const Brick> bricks)
    {
        for (const Brick& brick : bricks)
            if (const std::size_t key = keyOf(brick); _keys.empty() || _keys.back() != key) _keys.push_back(key);
        std::sort(_keys.begin(), _keys.end());
        _keys.erase(std::unique(_keys.begin(), _keys.end()), _keys.end());
        _count = _keys.size();
    }

    glm::ivec2 _first{std::numeric_limits<int>::max()};
    std::size_t _width = 0;
    std::size_t _count = 0;
    std::vector<std::size_t> _keys; // in ascending order; empty if every block has its number
};

/** Sorts the bricks of one layer of blocks into blocks: first the bricks with studs, then the others. */
class BlockLayer
{
public:
    /** @param bricks the model's bricks in this layer. */
    BlockLayer(const BrickModel& model, std::span<const Brick> bricks) :
        _model(model), _bricks(bricks), _stud(SIDE_RIGHT << (2 * model.getGrid().getUpIndex())), _numbers(bricks),
        _blocks(2 * _numbers.getCount())
    {
    }

    BrickPoints sort()
    {
        for (const Brick& brick : _bricks)
            if (brick.openSides != 0) blockOf(brick).include(brick);

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
        for (const Brick& brick : _bricks)
            if (brick.openSides != 0) result.points[static_cast<std::size_t>(blockOf(brick).first++)] = pack(brick);
        return result;
    }

private:
    BrickBlock& blockOf(const Brick& brick)
    {
        const std::size_t number = _numbers.find(brick);
        return _blocks[brick.openSides & _stud ? number : _numbers.getCount() + number];
    }

    BrickPoint pack(const Brick& brick) const
    {
        if (_model.getParts().empty()) return packBrick(brick);
        const auto index = static_cast<std::size_t>(&brick - _model.getBricks().data());
        return packBrick(brick, _model.getParts()[_model.getPartIndices()[index]], _model.getGrid().getUpIndex());
    }

    const BrickModel& _model;
    std::span<const Brick> _bricks;
    int _stud; // the side that has a stud when it is open
    BlockNumbers _numbers;
    std::vector<BrickBlock> _blocks; // including empty ones
};

/** The sides of a cell whose neighbour is of the same part. */
std::uint32_t findJoinedSides(const Brick& brick, const Part& part)
{
    std::uint32_t sides = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const int place = brick.cell[axis] - part.cell[axis];
        if (place > 0) sides |= std::uint32_t(SIDE_LEFT) << (2 * axis);
        if (place + 1 < part.size[axis]) sides |= std::uint32_t(SIDE_RIGHT) << (2 * axis);
    }
    return sides;
}

/** The code of a part's length in a BrickPoint. */
std::uint32_t lengthCode(int cells)
{
    return static_cast<std::uint32_t>(std::clamp(cells, 2, 5) - 2);
}

/** A pseudo-random number of a part, from its position, so that a part that stays keeps its look. */
std::uint32_t numberOf(const Part& part)
{
    std::uint32_t number = part.cell[0] * 0x9e3779b1u ^ part.cell[1] * 0x85ebca77u ^ part.cell[2] * 0xc2b2ae3du;
    number = (number ^ number >> 15) * 0x2c1b3c6du;
    return (number ^ number >> 12) % NO_PART;
}

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
            red | std::uint32_t(green) << 8 | std::uint32_t(blue) << 16 | NO_PART << 24};
}

BrickPoint packBrick(const Brick& brick, const Part& part, int up)
{
    const auto other = static_cast<std::size_t>(3 - up);
    BrickPoint point = packBrick(brick);
    point[1] |=
        findJoinedSides(brick, part) << 22 | lengthCode(part.size[0]) << 28 | lengthCode(part.size[other]) << 30;
    point[2] = (point[2] & 0xffffffu) | numberOf(part) << 24;
    return point;
}

Brick unpackBrick(const BrickPoint& point)
{
    Brick brick;
    brick.cell = {static_cast<std::uint16_t>(point[0]), static_cast<std::uint16_t>(point[0] >> 16),
                  static_cast<std::uint16_t>(point[1])};
    brick.openSides = static_cast<std::uint8_t>(point[1] >> 16 & 63u);
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
        blocks.back().include(brick);
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
        layers[layer] =
            BlockLayer(model, std::span(bricks).subspan(begins[layer], begins[layer + 1] - begins[layer])).sort();
    };
    forEachIndex(layers.size(), sortLayer);
    return join(layers);
}

} // namespace osgLego
