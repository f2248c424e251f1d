#include <osgLego/BrickCodec.h>

#include <osgLego/data/ByteReader.h>
#include <osgLego/data/ByteWriter.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <zlib.h>

// The format, with numbers in little-endian order:
//
//     version     32 bits
//     check sum   32 bits: CRC-32 of all other bytes
//
// This much is common to all versions, so that an older program can tell a newer version from a damaged file. Version 1
// continues with:
//
//     dimensions  3 * 32 bits
//     up axis      8 bits: 1 for y, 2 for z
//     origin      3 * 64 bits, floating point
//     cell size   3 * 64 bits, floating point
//     bricks      64 bits: their number
//     size        64 bits: that of the following data when decompressed, in bytes
//     data        by zlib: the runs of covered cells in the order of their numbers, then the reds, greens and blues of
//                 the bricks, 8 bits each
//
// A run is the number of empty cells before it, and its own length. Both take 7 bits of each byte, lowest first; the
// highest bit is set in all bytes but the last. A colour is stored as the difference from that of the brick before.

namespace osgLego
{

namespace
{

constexpr std::uint32_t VERSION = 1;
constexpr std::size_t CHECK_SUM_PLACE = 4;
constexpr std::size_t HEADER_SIZE = 8;
// The compressed data is at most this many times smaller (deflate's limit), so that a bad size allocates no more.
constexpr std::uint64_t LARGEST_RATIO = 1032;
constexpr int LARGEST_DIMENSION = std::numeric_limits<std::uint16_t>::max() + 1;

std::uint32_t checkSumOf(std::string_view bytes)
{
    const auto add = [](uLong sum, std::string_view part)
    { return crc32_z(sum, reinterpret_cast<const Bytef*>(part.data()), part.size()); };
    return static_cast<std::uint32_t>(
        add(add(crc32_z(0, nullptr, 0), bytes.substr(0, CHECK_SUM_PLACE)), bytes.substr(HEADER_SIZE)));
}

std::uint64_t numberOf(const BrickGrid& grid, const Brick& brick)
{
    const auto width = static_cast<std::uint64_t>(grid.dimensions.x);
    const auto depth = static_cast<std::uint64_t>(grid.dimensions.y);
    return brick.cell[0] + width * (brick.cell[1] + depth * brick.cell[2]);
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
        const std::uint64_t number = numberOf(model.getGrid(), brick);
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
    const auto width = static_cast<std::uint64_t>(grid.dimensions.x);
    const auto depth = static_cast<std::uint64_t>(grid.dimensions.y);
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
            brick->cell = {static_cast<std::uint16_t>(number % width),
                           static_cast<std::uint16_t>(number / width % depth),
                           static_cast<std::uint16_t>(number / width / depth)};
    }
    return true;
}

void writeColors(const BrickModel& model, ByteWriter& writer)
{
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
        std::uint8_t before = 0;
        for (const Brick& brick : model.getBricks())
        {
            writer.writeNumber(static_cast<std::uint8_t>(brick.color[channel] - before));
            before = brick.color[channel];
        }
    }
}

void readColors(ByteReader& reader, std::vector<Brick>& bricks)
{
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
        std::uint8_t before = 0;
        for (Brick& brick : bricks)
        {
            before = static_cast<std::uint8_t>(before + reader.readNumber<std::uint8_t>());
            brick.color[channel] = before;
        }
    }
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

/** Read version 1, after the header. @return null if a value is impossible. */
osg::ref_ptr<const BrickModel> readModel(ByteReader& reader)
{
    BrickGrid grid;
    if (!readGrid(reader, grid)) return nullptr;
    const auto numBricks = reader.readNumber<std::uint64_t>();
    const auto size = reader.readNumber<std::uint64_t>();
    if (reader.hasFailed()) return nullptr;
    const std::optional<std::string> data = decompressData(reader.readRest(), size);
    // Each brick has a colour of three bytes.
    if (!data || numBricks > size / 3) return nullptr;
    std::vector<Brick> bricks(numBricks);
    ByteReader dataReader(*data);
    if (!readRuns(dataReader, grid, bricks)) return nullptr;
    readColors(dataReader, bricks);
    if (dataReader.hasFailed() || !dataReader.readRest().empty()) return nullptr;
    return BrickModel::create(grid, std::move(bricks));
}

} // namespace

std::string encodeBricks(const BrickModel& model)
{
    ByteWriter data;
    writeRuns(model, data);
    writeColors(model, data);

    ByteWriter writer;
    writer.writeNumber(VERSION);
    writer.writeNumber(std::uint32_t(0)); // the check sum, which is not known yet
    writeGrid(model.getGrid(), writer);
    writer.writeNumber(static_cast<std::uint64_t>(model.getBricks().size()));
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
    if (version != VERSION)
    {
        error = "the stored bricks have version " + std::to_string(version) + " of their format; expected version " +
                std::to_string(VERSION) + ", or a newer osgLego to read them";
        return nullptr;
    }
    osg::ref_ptr<const BrickModel> model = readModel(reader);
    if (!model) error = "the stored bricks contradict their grid; expected each brick in a cell of its own";
    return model;
}

} // namespace osgLego
