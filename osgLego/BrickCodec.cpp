#include <osgLego/BrickCodec.h>

#include <osgLego/data/ByteReader.h>
#include <osgLego/data/ByteWriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

#include <osg/Notify>
#include <zlib.h>

// The format, with numbers in little-endian order:
//
//     version     32 bits
//     check sum   32 bits: CRC-32 of all other bytes
//
// This much is common to all versions, so that an older program can tell a newer version from a damaged file. Version
// 1, of models without parts, and version 2, of models of parts, continue with:
//
//     dimensions  3 * 32 bits
//     up axis      8 bits: 1 for y, 2 for z
//     origin      3 * 64 bits, floating point
//     cell size   3 * 64 bits, floating point
//     number      64 bits: of bricks or parts
//     size        64 bits: that of the following data when decompressed, in bytes
//     data        by zlib
//
// The data of version 1 are the runs of covered cells in the order of their numbers, then the reds, greens and blues of
// the bricks, 8 bits each. A run is the number of empty cells before it, and its own length. A colour is stored as the
// difference from that of the brick before.
//
// The data of version 2 are, for the parts in the order of their lowest cells, the differences of the numbers of these
// cells from those before, then the sizes along x, y and z, 8 bits each, then the reds, greens and blues, as above,
// then the colour codes, 32 bits each.
//
// Numbers without a size given here take 7 bits of each byte, lowest first; the highest bit is set in all bytes but the
// last.

namespace osgLego
{

namespace
{

constexpr std::uint32_t VERSION_OF_CELLS = 1;
constexpr std::uint32_t VERSION_OF_PARTS = 2;
constexpr std::size_t CHECK_SUM_PLACE = 4;
constexpr std::size_t HEADER_SIZE = 8;
// The compressed data is at most this many times smaller (deflate's limit), so that a bad size allocates no more.
constexpr std::uint64_t LARGEST_RATIO = 1032;
// The number of cells in the largest part: a brick of 2x8 studs and three plates.
constexpr int LARGEST_PART = 48;
// The number of cells of all parts, as many as filling a model gives, so that decoding needs at most a few gigabytes.
constexpr std::uint64_t MOST_CELLS_OF_PARTS = std::uint64_t(1) << 26;
// The fewest bytes of a brick or part in the data: its colour, or a step, a size, a colour and its code.
constexpr std::uint64_t SMALLEST_BRICK = 3;
constexpr std::uint64_t SMALLEST_PART = 11;
constexpr const char* BAD_BRICKS = "the stored bricks contradict their grid; expected each brick in a cell of its own";
constexpr const char* BAD_PARTS =
    "the stored parts contradict their grid; expected parts within it that do not overlap";
constexpr int LARGEST_DIMENSION = std::numeric_limits<std::uint16_t>::max() + 1;

std::uint32_t checkSumOf(std::string_view bytes)
{
    const auto add = [](uLong sum, std::string_view part)
    { return crc32_z(sum, reinterpret_cast<const Bytef*>(part.data()), part.size()); };
    return static_cast<std::uint32_t>(
        add(add(crc32_z(0, nullptr, 0), bytes.substr(0, CHECK_SUM_PLACE)), bytes.substr(HEADER_SIZE)));
}

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

void writeGrid(const BrickGrid& grid, ByteWriter& writer)
{
    for (int axis = 0; axis < 3; ++axis)
        writer.writeNumber(static_cast<std::uint32_t>(grid.dimensions[axis]));
    writer.writeNumber(static_cast<std::uint8_t>(grid.getUpIndex()));
    for (int axis = 0; axis < 3; ++axis)
        writer.writeDouble(grid.origin[axis]);
    for (int axis = 0; axis < 3; ++axis)
        writer.writeDouble(grid.cellSize[axis]);
}

bool readGrid(ByteReader& reader, BrickGrid& grid)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto cells = reader.readNumber<std::uint32_t>();
        if (cells > LARGEST_DIMENSION) return false;
        grid.dimensions[axis] = static_cast<int>(cells);
    }
    const auto up = reader.readNumber<std::uint8_t>();
    if (up != 1 && up != 2) return false;
    grid.upAxis = up == 1 ? UpAxis::Y : UpAxis::Z;
    for (int axis = 0; axis < 3; ++axis)
        grid.origin[axis] = reader.readDouble();
    for (int axis = 0; axis < 3; ++axis)
        grid.cellSize[axis] = reader.readDouble();
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(grid.origin[axis]) || !std::isfinite(grid.cellSize[axis]) || !(grid.cellSize[axis] > 0.0))
            return false;
    return true;
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

int countCells(const Part& part)
{
    return part.size[0] * part.size[1] * part.size[2];
}

bool isInGrid(const Part& part, const BrickGrid& grid)
{
    for (int axis = 0; axis < 3; ++axis)
        if (part.getSize()[axis] == 0 || part.getCell()[axis] + part.getSize()[axis] > grid.dimensions[axis])
            return false;
    return true;
}

/** @return one sentence if parts are too large to be stored; otherwise empty. */
std::string findObstacle(const std::vector<Part>& parts)
{
    std::uint64_t numCells = 0;
    for (const Part& part : parts)
    {
        if (countCells(part) > LARGEST_PART)
            return "a part has " + std::to_string(countCells(part)) + " cells; expected at most " +
                   std::to_string(LARGEST_PART) + " in each part of stored bricks";
        numCells += static_cast<std::uint64_t>(countCells(part));
    }
    if (numCells > MOST_CELLS_OF_PARTS)
        return "the parts cover " + std::to_string(numCells) + " cells; expected at most " +
               std::to_string(MOST_CELLS_OF_PARTS) + " in stored bricks";
    return {};
}

/** Records which cells are taken, in blocks, so that parts far from each other need no memory for the cells between
 * them. */
class TakenCells
{
public:
    /** Take the cells of a part. @return false if one of them is taken. */
    bool take(const Part& part)
    {
        const glm::ivec3 end = part.getCell() + part.getSize();
        for (int z = part.cell[2]; z < end.z; ++z)
            for (int y = part.cell[1]; y < end.y; ++y)
                for (int x = part.cell[0]; x < end.x; ++x)
                    if (!take(glm::ivec3(x, y, z))) return false;
        return true;
    }

private:
    static constexpr int SIDE = 4; // a block has 64 cells, the bits of one number

    bool take(const glm::ivec3& cell)
    {
        const glm::ivec3 block = cell / SIDE;
        const glm::ivec3 place = cell % SIDE;
        const auto key = [&block](int axis) { return static_cast<std::uint64_t>(block[axis]); };
        std::uint64_t& bits = _blocks[key(0) << 40 | key(1) << 20 | key(2)];
        const std::uint64_t bit = std::uint64_t(1) << (place.x + SIDE * (place.y + SIDE * place.z));
        const bool isFree = (bits & bit) == 0;
        bits |= bit;
        return isFree;
    }

    std::unordered_map<std::uint64_t, std::uint64_t> _blocks;
};

bool overlap(const std::vector<Part>& parts)
{
    TakenCells taken;
    return !std::all_of(parts.begin(), parts.end(), [&taken](const Part& part) { return taken.take(part); });
}

/** Fill in the parts. @return false if a part leaves the grid, or two begin in the same cell. */
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
    return std::all_of(parts.begin(), parts.end(), [&grid](const Part& part) { return isInGrid(part, grid); });
}

std::string compressData(const std::string& data)
{
    uLongf size = compressBound(data.size());
    std::string compressed(size, '\0');
    compress(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
             data.size()); // it only fails if there is too little room for the result
    compressed.resize(size);
    return compressed;
}

/** @return nothing unless there are exactly `size` bytes. */
std::optional<std::string> decompressData(std::string_view compressed, std::uint64_t size)
{
    if (size > LARGEST_RATIO * compressed.size()) return std::nullopt;
    std::string data(size, '\0');
    uLongf written = data.size();
    const int result = uncompress(reinterpret_cast<Bytef*>(data.data()), &written,
                                  reinterpret_cast<const Bytef*>(compressed.data()), compressed.size());
    if (result != Z_OK || written != size) return std::nullopt;
    return data;
}

/** @return null if a value is impossible. */
osg::ref_ptr<const BrickModel> readBrickData(ByteReader& reader, const BrickGrid& grid, std::uint64_t count)
{
    std::vector<Brick> bricks(count);
    if (!readRuns(reader, grid, bricks)) return nullptr;
    readColors(reader, bricks);
    if (reader.hasFailed() || !reader.readRest().empty()) return nullptr;
    return BrickModel::create(grid, std::move(bricks));
}

/** @return null if a value is impossible, or parts overlap, with one sentence in `error` if they are too large. */
osg::ref_ptr<const BrickModel> readPartData(ByteReader& reader, const BrickGrid& grid, std::uint64_t count,
                                            std::string& error)
{
    std::vector<Part> parts(count);
    if (!readParts(reader, grid, parts) || reader.hasFailed() || !reader.readRest().empty()) return nullptr;
    // The cells of the parts need much more memory than the parts, so everything is checked before they are made.
    if (const std::string obstacle = findObstacle(parts); !obstacle.empty())
    {
        error = obstacle;
        return nullptr;
    }
    return overlap(parts) ? nullptr : BrickModel::createOfParts(grid, std::move(parts));
}

/** Read a model, after the header. @return null if a value is impossible, with one sentence in `error` if parts are too
 * large. */
osg::ref_ptr<const BrickModel> readModel(ByteReader& reader, std::uint32_t version, std::string& error)
{
    BrickGrid grid;
    if (!readGrid(reader, grid)) return nullptr;
    const auto count = reader.readNumber<std::uint64_t>();
    const auto size = reader.readNumber<std::uint64_t>();
    if (reader.hasFailed()) return nullptr;
    const std::optional<std::string> data = decompressData(reader.readRest(), size);
    const bool hasParts = version == VERSION_OF_PARTS;
    if (!data || count > size / (hasParts ? SMALLEST_PART : SMALLEST_BRICK)) return nullptr;
    ByteReader dataReader(*data);
    return hasParts ? readPartData(dataReader, grid, count, error) : readBrickData(dataReader, grid, count);
}

} // namespace

std::string encodeBricks(const BrickModel& model)
{
    if (const std::string obstacle = findObstacle(model.getParts()); !obstacle.empty())
    {
        OSG_WARN << "osgLego: " << obstacle << std::endl;
        return {};
    }
    const bool hasParts = !model.getParts().empty();
    ByteWriter data;
    if (hasParts)
        writeParts(model, data);
    else
    {
        writeRuns(model, data);
        writeColors(model.getBricks(), data);
    }

    ByteWriter writer;
    writer.writeNumber(hasParts ? VERSION_OF_PARTS : VERSION_OF_CELLS);
    writer.writeNumber(std::uint32_t(0)); // the check sum, which is not known yet
    writeGrid(model.getGrid(), writer);
    writer.writeNumber(static_cast<std::uint64_t>(hasParts ? model.getParts().size() : model.getBricks().size()));
    writer.writeNumber(static_cast<std::uint64_t>(data.getBytes().size()));
    std::string bytes = writer.getBytes() + compressData(data.getBytes());

    ByteWriter checkSum;
    checkSum.writeNumber(checkSumOf(bytes));
    return bytes.replace(CHECK_SUM_PLACE, HEADER_SIZE - CHECK_SUM_PLACE, checkSum.getBytes());
}

osg::ref_ptr<const BrickModel> decodeBricks(std::string_view bytes, std::string& error)
{
    ByteReader reader(bytes);
    const auto version = reader.readNumber<std::uint32_t>();
    const auto checkSum = reader.readNumber<std::uint32_t>();
    if (reader.hasFailed() || checkSumOf(bytes) != checkSum)
    {
        error = "the stored bricks are damaged or incomplete; expected the bytes that were written";
        return nullptr;
    }
    if (version != VERSION_OF_CELLS && version != VERSION_OF_PARTS)
    {
        error = "the stored bricks have version " + std::to_string(version) + " of their format; expected version " +
                std::to_string(VERSION_OF_CELLS) + " or " + std::to_string(VERSION_OF_PARTS) +
                ", or a newer osgLego to read them";
        return nullptr;
    }
    std::string obstacle = version == VERSION_OF_PARTS ? BAD_PARTS : BAD_BRICKS;
    osg::ref_ptr<const BrickModel> model = readModel(reader, version, obstacle);
    if (!model) error = obstacle;
    return model;
}

} // namespace osgLego
