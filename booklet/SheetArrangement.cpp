#include "SheetArrangement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgLego
{

namespace
{

constexpr double SMALL_PITCH = 1.5; // millimetres; smaller studs need wider columns
constexpr double LARGE_PITCH = 3.0; // likewise; larger studs are no better
constexpr double USUAL_HEAD = 40.0; // blocks with more above their pictures have smaller ones

} // namespace

double SheetArrangement::getColumnWidth(std::size_t numColumns)
{
    const auto number = static_cast<double>(numColumns);
    return (WIDTH - (number - 1.0) * COLUMN_SPACE) / number;
}

SheetArrangement::SheetArrangement(std::span<const SheetBlock> blocks, double header, std::size_t mostColumns) :
    _blocks(blocks), _header(std::min(header, 0.5 * HEIGHT))
{
    chooseColumns(mostColumns);
    const std::vector<std::size_t> ends = divide(countFullColumns());
    std::size_t first = 0;
    for (std::size_t column = 0; column < ends.size(); ++column)
    {
        if (column % _numColumns == 0) _sheets.emplace_back();
        _sheets.back().push_back(createColumn(first, ends[column], getCapacity(column)));
        first = ends[column];
    }
}

/** Choose the number of columns and the scale. */
void SheetArrangement::chooseColumns(std::size_t mostColumns)
{
    constexpr double LEAST_SHARE = 0.65; // of the widest pictures that fit
    constexpr int NUM_SHARES = 36;
    constexpr double SCALE_EXPONENT = 1.1;  // pictures that are larger by a tenth are worth 11 % more sheets
    constexpr double COST_OF_EMPTINESS = 1; // sheets, for one that is not half full
    double lowest = std::numeric_limits<double>::max();
    std::size_t numColumns = 1;
    double pitch = 0.0;
    for (_numColumns = 1; _numColumns <= std::min(mostColumns, _blocks.size()); ++_numColumns)
    {
        const double widest = findWidestPitch();
        for (int index = 0; index < NUM_SHARES; ++index)
        {
            _pitch = widest * (1.0 - (1.0 - LEAST_SHARE) * index / (NUM_SHARES - 1.0));
            if (_numColumns > 1 && _pitch < SMALL_PITCH) break;
            const std::vector<std::size_t> ends = divide(countFullColumns());
            const std::size_t numSheets = (ends.size() + _numColumns - 1) / _numColumns;
            const double cost =
                (static_cast<double>(numSheets) + COST_OF_EMPTINESS * static_cast<double>(countEmpty(ends))) /
                std::pow(std::min(_pitch, LARGE_PITCH), SCALE_EXPONENT);
            if (cost >= lowest) continue;
            lowest = cost;
            numColumns = _numColumns;
            pitch = _pitch;
        }
    }
    _numColumns = numColumns;
    _pitch = pitch;
}

/** The number of columns of full sheets, as far as there are blocks for all columns. */
std::size_t SheetArrangement::countFullColumns() const
{
    const std::size_t numSheets = (countColumns() + _numColumns - 1) / _numColumns;
    return std::min(numSheets * _numColumns, _blocks.size());
}

/** The number of sheets that are not half full. @param ends of the columns. */
std::size_t SheetArrangement::countEmpty(const std::vector<std::size_t>& ends) const
{
    std::size_t number = 0;
    std::size_t first = 0;
    double highest = 0.0;
    for (std::size_t column = 0; column < ends.size(); ++column)
    {
        double height = HEIGHT - getCapacity(column) - BLOCK_SPACE;
        for (; first < ends[column]; ++first)
            height += getHeight(_blocks[first]);
        highest = std::max(highest, height);
        if ((column + 1) % _numColumns != 0 && column + 1 < ends.size()) continue;
        number += highest < 0.5 * HEIGHT ? 1 : 0;
        highest = 0.0;
    }
    return number;
}

/** The height of a column, numbered over all sheets. */
double SheetArrangement::getCapacity(std::size_t column) const
{
    return column < _numColumns ? HEIGHT - _header : HEIGHT;
}

/** The largest scale at which each picture of the model fits into a column. */
double SheetArrangement::findWidestPitch() const
{
    double pitch = std::numeric_limits<double>::max();
    for (const SheetBlock& block : _blocks)
        if (block.isOfModel)
            pitch = std::min({pitch, block.mostPitch, getColumnWidth(_numColumns) / block.studs.x,
                              (HEIGHT - USUAL_HEAD) / block.studs.y});
    return pitch;
}

double SheetArrangement::getPitch(const SheetBlock& block) const
{
    const glm::dvec2 space(getColumnWidth(_numColumns) - block.lostWidth,
                           HEIGHT - block.heads[_numColumns - 1] - PICTURE_SPACE);
    return std::min({block.isOfModel ? _pitch : block.mostPitch, space.x / block.studs.x, space.y / block.studs.y});
}

double SheetArrangement::getHeight(const SheetBlock& block) const
{
    const double picture = block.studs.y > 0.0 ? PICTURE_SPACE + block.studs.y * getPitch(block) : 0.0;
    return block.heads[_numColumns - 1] + picture + BLOCK_SPACE;
}

/** The least number of columns. */
std::size_t SheetArrangement::countColumns() const
{
    std::size_t column = 0;
    double height = 0.0;
    for (const SheetBlock& block : _blocks)
    {
        const double own = getHeight(block);
        if (height > 0.0 && height + own > getCapacity(column) + BLOCK_SPACE)
        {
            ++column;
            height = 0.0;
        }
        height += own;
    }
    return column + 1;
}

/** Divide the blocks into columns so that the least space remains free, by the sum of squares.
 * @return the ends of the columns. */
std::vector<std::size_t> SheetArrangement::divide(std::size_t numColumns) const
{
    const std::size_t numBlocks = _blocks.size();
    constexpr double IMPOSSIBLE = 1e18;
    constexpr double TOO_HIGH = 1e9; // for a single block that is higher than its column
    using Row = std::vector<double>;
    std::vector<Row> costs(numColumns + 1, Row(numBlocks + 1, IMPOSSIBLE));
    std::vector<std::vector<std::size_t>> firsts(numColumns + 1, std::vector<std::size_t>(numBlocks + 1, 0));
    costs[0][0] = 0.0;
    for (std::size_t column = 1; column <= numColumns; ++column)
        for (std::size_t first = 0; first < numBlocks; ++first)
        {
            if (costs[column - 1][first] >= IMPOSSIBLE) continue;
            double height = -BLOCK_SPACE;
            for (std::size_t end = first + 1; end <= numBlocks; ++end)
            {
                height += getHeight(_blocks[end - 1]);
                const double free = getCapacity(column - 1) - height;
                if (free < 0.0 && end > first + 1) break;
                const double cost = costs[column - 1][first] + free * free + (free < 0.0 ? TOO_HIGH : 0.0);
                if (cost >= costs[column][end]) continue;
                costs[column][end] = cost;
                firsts[column][end] = first;
            }
        }
    std::vector<std::size_t> ends(numColumns);
    std::size_t end = numBlocks;
    for (std::size_t column = numColumns; column > 0; --column)
    {
        ends[column - 1] = end;
        end = firsts[column][end];
    }
    return ends;
}

/** Place the blocks of a column, and spread its free space. */
SheetColumn SheetArrangement::createColumn(std::size_t first, std::size_t end, double capacity) const
{
    constexpr double MOST_SPREAD = 12.0; // between blocks
    double height = -BLOCK_SPACE;
    for (std::size_t block = first; block < end; ++block)
        height += getHeight(_blocks[block]);
    const double spread = std::clamp((capacity - height) / static_cast<double>(end - first), 0.0, MOST_SPREAD);
    SheetColumn column;
    for (std::size_t block = first; block < end; ++block)
    {
        const SheetBlock& own = _blocks[block];
        // Under a high header, a single block may have a smaller picture.
        const double highest = capacity - own.heads[_numColumns - 1] - PICTURE_SPACE;
        column.push_back({block, std::min(getHeight(own) - BLOCK_SPACE, capacity), 0.0,
                          std::min(getPitch(own), highest / own.studs.y)});
    }
    for (std::size_t place = 0; place + 1 < column.size(); ++place)
        column[place].space = BLOCK_SPACE + spread;
    return column;
}

} // namespace osgLego
