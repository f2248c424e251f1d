#include <osgLego/data/BrickRecords.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace osgLego
{

namespace
{

using Cell = std::array<std::uint16_t, 3>;

std::uint64_t numberOf(const BrickGrid& grid, const Cell& cell)
{
    const auto width = static_cast<std::uint64_t>(grid.dimensions.x);
    const auto depth = static_cast<std::uint64_t>(grid.dimensions.y);
    return cell[0] + width * (cell[1] + depth * cell[2]);
}

/** The inverse of numberOf(). */
Cell cellOf(const BrickGrid& grid, std::uint64_t number)
{
    const auto width = static_cast<std::uint64_t>(grid.dimensions.x);
    const auto depth = static_cast<std::uint64_t>(grid.dimensions.y);
    return {static_cast<std::uint16_t>(number % width), static_cast<std::uint16_t>(number / width % depth),
            static_cast<std::uint16_t>(number / width / depth)};
}

void writeRuns(const BrickModel& model, ByteWriter& writer)
{
    std::uint64_t begin = 0; // of the run; its end, and the end of the run before, are cells after the last one
    std::uint64_t end = 0;
    std::uint64_t endBefore = 0;
    const auto writeRun = [&]
    {
        if (begin == end) return;
        writer.writeShort(begin - endBefore);
        writer.writeShort(end - begin);
        endBefore = end;
    };
    for (const Brick& brick : model.getBricks())
    {
        const std::uint64_t number = numberOf(model.getGrid(), brick.cell);
        if (number != end)
        {
            writeRun();
            begin = number;
        }
        end = number + 1;
    }
    writeRun();
}

/** Fill in the cells of the bricks. @return false if the runs leave the grid or have another number of cells. */
bool readRuns(ByteReader& reader, const BrickGrid& grid, std::vector<Brick>& bricks)
{
    const std::uint64_t numCells = grid.getNumCells();
    std::uint64_t number = 0;
    for (auto brick = bricks.begin(); brick != bricks.end();)
    {
        const std::uint64_t gap = reader.readShort();
        const std::uint64_t length = reader.readShort();
        if (length == 0 || length > static_cast<std::uint64_t>(bricks.end() - brick)) return false;
        if (gap > numCells - number || length > numCells - number - gap) return false;
        number += gap;
        for (const std::uint64_t end = number + length; number < end; ++number, ++brick)
            brick->cell = cellOf(grid, number);
    }
    return true;
}

/** Write the colours of bricks or parts. */
template <typename Items>
void writeColors(const Items& items, ByteWriter& writer)
{
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
        std::uint8_t before = 0;
        for (const auto& item : items)
        {
            writer.writeNumber(static_cast<std::uint8_t>(item.color[channel] - before));
            before = item.color[channel];
        }
    }
}

template <typename Items>
void readColors(ByteReader& reader, Items& items)
{
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
        std::uint8_t before = 0;
        for (auto& item : items)
        {
            before = static_cast<std::uint8_t>(before + reader.readNumber<std::uint8_t>());
            item.color[channel] = before;
        }
    }
}

bool isInGrid(const Part& part, const BrickGrid& grid)
{
    for (int axis = 0; axis < 3; ++axis)
        if (part.getSize()[axis] == 0 || part.getCell()[axis] + part.getSize()[axis] > grid.dimensions[axis])
            return false;
    return true;
}

} // namespace

void writeBricks(const BrickModel& model, ByteWriter& writer)
{
    writeRuns(model, writer);
    writeColors(model.getBricks(), writer);
}

void writeParts(const BrickModel& model, ByteWriter& writer)
{
    const std::vector<Part>& parts = model.getParts();
    std::uint64_t before = 0;
    for (const Part& part : parts)
    {
        const std::uint64_t number = numberOf(model.getGrid(), part.cell);
        writer.writeShort(number - before);
        before = number;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const Part& part : parts)
            writer.writeNumber(part.size[axis]);
    writeColors(parts, writer);
    for (const Part& part : parts)
        writer.writeNumber(static_cast<std::uint32_t>(part.colorCode));
}

bool readBricks(ByteReader& reader, const BrickGrid& grid, std::vector<Brick>& bricks)
{
    if (!readRuns(reader, grid, bricks)) return false;
    readColors(reader, bricks);
    return !reader.hasFailed();
}

bool readParts(ByteReader& reader, const BrickGrid& grid, std::vector<Part>& parts)
{
    const std::uint64_t numCells = grid.getNumCells();
    std::uint64_t number = 0;
    for (Part& part : parts)
    {
        const std::uint64_t step = reader.readShort();
        const bool isFirst = &part == &parts.front();
        if (step >= numCells - number || (step == 0 && !isFirst)) return false;
        number += step;
        part.cell = cellOf(grid, number);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (Part& part : parts)
            part.size[axis] = reader.readNumber<std::uint8_t>();
    readColors(reader, parts);
    for (Part& part : parts)
        part.colorCode = static_cast<std::int32_t>(reader.readNumber<std::uint32_t>());
    return !reader.hasFailed() &&
           std::all_of(parts.begin(), parts.end(), [&grid](const Part& part) { return isInGrid(part, grid); });
}

} // namespace osgLego
