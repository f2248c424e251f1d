#include "SheetArrangement.h"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

namespace osgLego
{

namespace
{

// The smallest studs in one, two and three columns, in millimetres. Below them, columns are fewer and wider; that of
// two is smaller, since one column instead of two doubles the number of sheets.
constexpr std::array<double, SheetBlock::MOST_COLUMNS> SMALL_PITCHES{0.0, 1.5, 1.75};
constexpr double BIGGEST_PITCH = 8.0;          // millimetres, true to life
constexpr double USUAL_HEAD = 40.0;            // blocks with more above their pictures have smaller ones
constexpr std::size_t MOST_BLOCKS = 40;        // of a sheet
constexpr double COST_OF_COLUMN_PARTING = 0.3; // of a heading from its block: that of a column that is free by 55 %
constexpr double LEAST_FILLING = 0.53;         // of a sheet that is half full; heights are estimates

} // namespace

double SheetArrangement::getColumnWidth(std::size_t numColumns)
{
    const auto number = static_cast<double>(numColumns);
    return (WIDTH - (number - 1.0) * COLUMN_SPACE) / number;
}

SheetArrangement::SheetArrangement(std::span<const SheetBlock> blocks, double header, std::size_t mostColumns,
                                   const FootFunction& getFoot) :
    _blocks(blocks),
    _header(header)
{
    for (std::size_t first = 0; getFoot && first < blocks.size(); ++first)
    {
        std::vector<double>& feet = _feet.emplace_back();
        for (std::size_t end = first + 1; end <= std::min(blocks.size(), first + MOST_BLOCKS); ++end)
            feet.push_back(getFoot(first, end));
    }
    Choice best = choose(mostColumns);
    if (_header > LEAST_FILLING * HEIGHT || best.cost >= SheetFilling::IMPOSSIBLE)
    {
        _isHeaderAlone = true;
        if (const Choice other = choose(mostColumns); other.cost < best.cost)
            best = other;
        else
            _isHeaderAlone = false;
    }
    if (best.cost >= SheetFilling::IMPOSSIBLE)
        throw std::invalid_argument("a block is higher than a sheet; expected at most MOST_HEAD without its picture");
    _numColumns = best.numColumns;
    _pitch = best.pitch;
    if (_isHeaderAlone) _sheets.emplace_back();
    createSheets(plan());
}

/** Choose the usual number of columns and the scale. */
SheetArrangement::Choice SheetArrangement::choose(std::size_t mostColumns)
{
    constexpr double LEAST_SHARE = 0.65; // of the widest pictures that fit
    constexpr int NUM_SHARES = 36;
    Choice best;
    for (_numColumns = 1; _numColumns <= std::min(mostColumns, _blocks.size()); ++_numColumns)
    {
        const double widest = findWidestPitch();
        for (int index = 0; index < NUM_SHARES; ++index)
        {
            _pitch = widest * (1.0 - (1.0 - LEAST_SHARE) * index / (NUM_SHARES - 1.0));
            if (_pitch < SMALL_PITCHES[_numColumns - 1]) break;
            const double numSheets = plan().back().cost;
            if (numSheets >= SheetFilling::IMPOSSIBLE) continue;
            // Pictures that are larger by a tenth are worth a tenth more sheets.
            const double cost = numSheets / std::min(_pitch, LARGE_PITCH);
            if (cost < best.cost) best = {cost, _numColumns, _pitch};
        }
    }
    return best;
}

/** The largest scale at which each picture of the model fits into a column. */
double SheetArrangement::findWidestPitch() const
{
    double pitch = SheetFilling::IMPOSSIBLE;
    for (const SheetBlock& block : _blocks)
        if (block.hasScale)
            pitch = std::min({pitch, block.mostPitch, (getColumnWidth(_numColumns) - block.lostWidth) / block.studs.x,
                              (HEIGHT - USUAL_HEAD) / block.studs.y});
    return pitch;
}

/** The best plans for each number of blocks. */
std::vector<SheetArrangement::Plan> SheetArrangement::plan() const
{
    std::vector<Plan> plans(_blocks.size() + 1);
    plans.front().cost = _isHeaderAlone ? 1.0 : 0.0;
    for (std::size_t first = 0; first < _blocks.size(); ++first)
        for (std::size_t numColumns = 1; numColumns <= _numColumns; ++numColumns)
            if (plans[first].cost < SheetFilling::IMPOSSIBLE) extendPlans(first, numColumns, plans);
    return plans;
}

/** Continue a plan by a sheet. */
void SheetArrangement::extendPlans(std::size_t first, std::size_t numColumns, std::vector<Plan>& plans) const
{
    // Sheets of more blocks may have higher feet.
    std::set<double> feet{0.0};
    if (!_feet.empty()) feet.insert(_feet[first].begin(), _feet[first].end());
    for (const double foot : feet)
        extendPlans({first, numColumns, {}, foot}, plans);
}

/** Continue a plan by a sheet with a foot. @param start the first block, the number of columns, and the foot. */
void SheetArrangement::extendPlans(const Part& start, std::vector<Plan>& plans) const
{
    const std::size_t first = start.first;
    const double capacity = getCapacity(start) + BLOCK_SPACE;
    std::vector<SheetFilling::Block> fillers;
    // The first block that begins beyond the last column does not matter.
    for (double sum = 0.0; first + fillers.size() < _blocks.size() && fillers.size() < MOST_BLOCKS &&
                           sum <= static_cast<double>(start.numColumns) * capacity;
         sum += fillers.back().height)
    {
        const SheetBlock& block = _blocks[first + fillers.size()];
        fillers.push_back({getHeight(block, start), block.isHeading ? COST_OF_COLUMN_PARTING : 0.0});
    }
    const SheetFilling filling(fillers, start.numColumns, capacity);
    for (std::size_t number = 1; number <= filling.getMostBlocks(); ++number)
    {
        if (filling.getCost(number) >= SheetFilling::IMPOSSIBLE || getFoot(first, number) != start.foot) continue;
        constexpr double COST_OF_SPACE = 0.5; // sheets, for free columns
        double cost = plans[first].cost + 1.0 + COST_OF_SPACE * filling.getCost(number);
        Plan& plan = plans[first + number];
        if (cost >= plan.cost) continue;
        Part part = start;
        part.ends = filling.findEnds(number);
        for (std::size_t& end : part.ends)
            end += first;
        cost += rate(part);
        if (cost < plan.cost) plan = {cost, part};
    }
}

/** Enlarge the pictures of a sheet if necessary. @return its cost, in sheets, apart from that of its space. */
double SheetArrangement::rate(Part& part) const
{
    constexpr double COST_OF_EMPTINESS = 10.0; // of a sheet that is not half full
    constexpr double COST_OF_CHANGE = 0.1;     // of the usual number of columns
    constexpr double COST_OF_GROWTH = 1.0;     // of the scale of a sheet
    constexpr double COST_OF_PARTING = 3.0;    // of a heading from the sheet of its block
    double cost = rateReduction(part);
    enlarge(part);
    if (part.growth > 1.0) cost += COST_OF_GROWTH;
    if (isEmpty(part)) cost += COST_OF_EMPTINESS;
    if (part.numColumns != _numColumns) cost += COST_OF_CHANGE;
    if (part.ends.back() < _blocks.size() && _blocks[part.ends.back() - 1].isHeading) cost += COST_OF_PARTING;
    return cost;
}

/** Enlarge the pictures of a sheet that is not half full until it is, as far as its columns permit. */
void SheetArrangement::enlarge(Part& part) const
{
    constexpr double MOST_GROWTH = 2.0;
    constexpr double STEP = 1.1;
    for (double growth = STEP; growth <= MOST_GROWTH && isEmpty(part); growth *= STEP)
        part.growth = growth;
}

/** Whether a sheet is not half full. */
bool SheetArrangement::isEmpty(const Part& part) const
{
    std::size_t block = part.first;
    return std::all_of(part.ends.begin(), part.ends.end(),
                       [&](std::size_t end)
                       {
                           double height = HEIGHT - getCapacity(part) - BLOCK_SPACE;
                           for (; block < end; ++block)
                               height += getHeight(_blocks[block], part);
                           return height < LEAST_FILLING * HEIGHT;
                       });
}

/** The height of the columns of a sheet. */
double SheetArrangement::getCapacity(const Part& part) const
{
    return HEIGHT - part.foot - (part.first == 0 && !_isHeaderAlone ? _header : 0.0);
}

double SheetArrangement::getFoot(std::size_t first, std::size_t numBlocks) const
{
    return _feet.empty() ? 0.0 : _feet[first][numBlocks - 1];
}

/** Pictures keep the scale of the usual columns if a sheet has fewer of them, unless they are enlarged, and unless a
 * block would be higher than its column. */
double SheetArrangement::getPitch(const SheetBlock& block, const Part& part, double capacity) const
{
    const std::size_t numColumns = part.growth > 1.0 ? part.numColumns : _numColumns;
    const glm::dvec2 space(getColumnWidth(numColumns) - block.lostWidth,
                           std::max(LEAST_PICTURE, capacity - block.heads[part.numColumns - 1] - PICTURE_SPACE));
    const double pitch = part.growth * std::min(block.hasScale ? _pitch : block.mostPitch,
                                                (getColumnWidth(_numColumns) - block.lostWidth) / block.studs.x);
    return std::min({pitch, BIGGEST_PITCH, space.x / block.studs.x, space.y / block.studs.y});
}

/** The height of a block, with the space below it. */
double SheetArrangement::getHeight(const SheetBlock& block, const Part& part) const
{
    const double picture =
        block.studs.y > 0.0 ? PICTURE_SPACE + block.studs.y * getPitch(block, part, getCapacity(part)) : 0.0;
    return block.heads[part.numColumns - 1] + picture + BLOCK_SPACE;
}

/** The cost of pictures that are smaller below a header than elsewhere. */
double SheetArrangement::rateReduction(const Part& part) const
{
    constexpr double COST_OF_REDUCTION = 3.0; // sheets, for a picture that disappears
    if (part.first > 0 || _isHeaderAlone) return 0.0;
    double cost = 0.0;
    for (std::size_t block = 0; block < part.ends.back(); ++block)
    {
        const double wanted = getPitch(_blocks[block], part, HEIGHT);
        cost += COST_OF_REDUCTION * (1.0 - getPitch(_blocks[block], part, HEIGHT - _header) / wanted);
    }
    return cost;
}

void SheetArrangement::createSheets(const std::vector<Plan>& plans)
{
    std::vector<Part> parts;
    for (std::size_t end = _blocks.size(); end > 0; end = parts.back().first)
        parts.push_back(plans[end].last);
    std::reverse(parts.begin(), parts.end());
    for (const Part& part : parts)
    {
        Sheet& sheet = _sheets.emplace_back();
        sheet.numColumns = part.numColumns;
        std::size_t first = part.first;
        for (const std::size_t end : part.ends)
        {
            sheet.columns.push_back(createColumn(first, end, part));
            first = end;
        }
    }
}

/** Place the blocks of a column, and spread its free space. */
SheetColumn SheetArrangement::createColumn(std::size_t first, std::size_t end, const Part& part) const
{
    constexpr double MOST_SPREAD = 12.0; // between blocks
    const double capacity = getCapacity(part);
    double height = -BLOCK_SPACE;
    for (std::size_t block = first; block < end; ++block)
        height += getHeight(_blocks[block], part);
    const double spread = std::clamp((capacity - height) / static_cast<double>(end - first), 0.0, MOST_SPREAD);
    SheetColumn column;
    for (std::size_t block = first; block < end; ++block)
    {
        const SheetBlock& own = _blocks[block];
        column.push_back({block, getHeight(own, part) - BLOCK_SPACE, 0.0, getPitch(own, part, capacity),
                          own.scales[part.numColumns - 1]});
    }
    for (std::size_t place = 0; place + 1 < column.size(); ++place)
        column[place].space = BLOCK_SPACE + spread;
    return column;
}

} // namespace osgLego
