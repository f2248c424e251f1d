#include <osgLego/BrickCodec.h>

#include <osgLego/data/BrickRecords.h>
#include <osgLego/data/ByteReader.h>
#include <osgLego/data/ByteWriter.h>
#include <osgLego/data/TakenCells.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

#include <osg/Notify>
#include <zlib.h>

// The format:
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
//     data        by zlib; data/BrickRecords.h describes it
//
// Numbers are in little-endian order.

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
// The fewest bytes of a brick or part in the data: its colour, or a step, a size, a colour and its code.
constexpr std::uint64_t SMALLEST_BRICK = 3;
constexpr std::uint64_t SMALLEST_PART = 11;
// The most bytes of either: two numbers of up to 10 bytes and a colour, or a number, sizes, a colour and its code.
constexpr std::uint64_t LARGEST_RECORD = 23;
constexpr const char* BAD_BRICKS = "the stored bricks contradict their grid; expected each brick in a cell of its own";
constexpr const char* BAD_PARTS =
    "the stored parts contradict their grid; expected parts within it that do not overlap";

std::uint32_t checkSumOf(std::string_view bytes)
{
    const auto add = [](uLong sum, std::string_view part)
    { return crc32_z(sum, reinterpret_cast<const Bytef*>(part.data()), part.size()); };
    return static_cast<std::uint32_t>(
        add(add(crc32_z(0, nullptr, 0), bytes.substr(0, CHECK_SUM_PLACE)), bytes.substr(HEADER_SIZE)));
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

/** @return one sentence if a grid has too many cells, or cells so long that tables of the space around bricks would not
 * fit into memory; otherwise empty. */
std::string findObstacleOfCells(const glm::dvec3& cells, const BrickGrid& grid)
{
    std::ostringstream text;
    if (!GridLimits::contain(cells, grid.getUpIndex()))
        text << std::setprecision(std::numeric_limits<std::uint32_t>::digits10 + 1) << "the bricks are in a grid of "
             << cells.x << " x " << cells.y << " x " << cells.z << " cells; expected at most "
             << GridLimits::describe(grid.getUpIndex()) << " in stored bricks";
    const auto [shortest, longest] = std::minmax({grid.cellSize.x, grid.cellSize.y, grid.cellSize.z});
    if (!(longest <= GridLimits::MOST_STRETCH * shortest))
        text << "the cells of the bricks are " << longest / shortest << " times as long as wide; expected at most "
             << GridLimits::MOST_STRETCH << " times in stored bricks";
    return text.str();
}

/** @return one sentence if a grid is so far away or so small that nothing could draw it; otherwise empty. OSG computes
 * views and bounds in single precision. */
std::string findObstacleToDrawing(const glm::dvec3& cells, const BrickGrid& grid)
{
    // Meshes end at SceneVertex::MAXIMUM_COORDINATE; a cell may be as long as they are, and begin a cell before them.
    constexpr double MOST_DISTANCE = 4e18;
    constexpr double LEAST_SIZE = 1e-18; // SceneTriangles ignores smaller meshes
    constexpr double ROUNDING = 0x1p-24; // of single precision
    const glm::dvec3 size = cells * grid.cellSize;
    const glm::dvec3 reach = glm::max(glm::abs(grid.origin), glm::abs(grid.origin + size));
    const double farthest = std::max({reach.x, reach.y, reach.z});
    const double longest = std::max({size.x, size.y, size.z});
    const double least = std::max(LEAST_SIZE, ROUNDING * farthest);
    std::ostringstream text;
    if (farthest > MOST_DISTANCE)
        text << "the bricks reach " << farthest << " model units; expected at most " << MOST_DISTANCE
             << " in stored bricks";
    else if (longest > 0.0 && longest < least) // a model without cells draws nothing
        text << "the longest side of the bricks is " << longest << " model units; expected at least " << least
             << " for bricks that reach " << farthest;
    return text.str();
}

/** @return one sentence if a grid can't be stored; otherwise empty. */
std::string findObstacleOfGrid(const glm::dvec3& cells, const BrickGrid& grid)
{
    std::string obstacle = findObstacleOfCells(cells, grid);
    return obstacle.empty() ? findObstacleToDrawing(cells, grid) : obstacle;
}

/** @return false if a value is impossible, with one sentence in `error` if the grid is too large. */
bool readGrid(ByteReader& reader, BrickGrid& grid, std::string& error)
{
    glm::dvec3 cells;
    for (int axis = 0; axis < 3; ++axis)
        cells[axis] = reader.readNumber<std::uint32_t>();
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
    if (const std::string obstacle = findObstacleOfGrid(cells, grid); !obstacle.empty())
    {
        error = obstacle;
        return false;
    }
    grid.dimensions = glm::ivec3(cells);
    return true;
}

int countCells(const Part& part)
{
    return part.size[0] * part.size[1] * part.size[2];
}

/** @return one sentence if there are too many bricks to be stored; otherwise empty. @param kind such as "bricks". */
std::string findObstacle(std::uint64_t count, const char* kind)
{
    if (count <= GridLimits::MOST_BRICKS) return {};
    return "there are " + std::to_string(count) + " " + kind + "; expected at most " +
           std::to_string(GridLimits::MOST_BRICKS) + " in stored bricks";
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
    return findObstacle(numCells, "cells of parts");
}

/** @return one sentence if a model is too large to be stored; otherwise empty. */
std::string findObstacle(const BrickModel& model)
{
    const BrickGrid& grid = model.getGrid();
    if (std::string obstacle = findObstacleOfGrid(grid.dimensions, grid); !obstacle.empty()) return obstacle;
    if (!model.getParts().empty()) return findObstacle(model.getParts());
    return findObstacle(model.getBricks().size(), "bricks");
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
    if (!readBricks(reader, grid, bricks) || !reader.readRest().empty()) return nullptr;
    return BrickModel::create(grid, std::move(bricks));
}

/** @return null if a value is impossible, or parts overlap, with one sentence in `error` if they are too large. */
osg::ref_ptr<const BrickModel> readPartData(ByteReader& reader, const BrickGrid& grid, std::uint64_t count,
                                            std::string& error)
{
    std::vector<Part> parts(count);
    if (!readParts(reader, grid, parts) || !reader.readRest().empty()) return nullptr;
    // The cells of the parts need much more memory than the parts, so everything is checked before they are made.
    if (const std::string obstacle = findObstacle(parts); !obstacle.empty())
    {
        error = obstacle;
        return nullptr;
    }
    return TakenCells::overlap(parts) ? nullptr : BrickModel::createOfParts(grid, std::move(parts));
}

/** Read a model, after the header. @return null if a value is impossible, with one sentence in `error` if the model is
 * too large. */
osg::ref_ptr<const BrickModel> readModel(ByteReader& reader, std::uint32_t version, std::string& error)
{
    BrickGrid grid;
    if (!readGrid(reader, grid, error)) return nullptr;
    const bool hasParts = version == VERSION_OF_PARTS;
    const auto count = reader.readNumber<std::uint64_t>();
    const auto size = reader.readNumber<std::uint64_t>();
    // A brick needs several bytes of the data, and the data is limited by that of the file: see decompressData().
    if (reader.hasFailed() || count > size / (hasParts ? SMALLEST_PART : SMALLEST_BRICK)) return nullptr;
    if (const std::string obstacle = findObstacle(count, hasParts ? "parts" : "bricks"); !obstacle.empty())
    {
        error = obstacle;
        return nullptr;
    }
    if (size > count * LARGEST_RECORD) return nullptr;
    const std::optional<std::string> data = decompressData(reader.readRest(), size);
    if (!data) return nullptr;
    ByteReader dataReader(*data);
    return hasParts ? readPartData(dataReader, grid, count, error) : readBrickData(dataReader, grid, count);
}

} // namespace

std::string encodeBricks(const BrickModel& model)
{
    if (const std::string obstacle = findObstacle(model); !obstacle.empty())
    {
        OSG_WARN << "osgLego: " << obstacle << std::endl;
        return {};
    }
    const bool hasParts = !model.getParts().empty();
    ByteWriter data;
    if (hasParts)
        writeParts(model, data);
    else
        writeBricks(model, data);

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
