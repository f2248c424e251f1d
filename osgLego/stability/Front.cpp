#include <osgLego/stability/Front.h>

#include <osgLego/data/ParallelLoop.h>
#include <osgLego/stability/StripKernels.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace osgLego
{

namespace
{

constexpr std::size_t WIDTH = StripKernels::NUM_ROWS;
constexpr std::size_t TILE = WIDTH * WIDTH;
// Loops with less work, in multiplications, take less time in one thread.
constexpr std::size_t LEAST_PARALLEL_WORK = 2'000'000;
// Columns of strips that are multiplied at a time, so that they stay in the cache.
constexpr std::size_t NUM_CACHED_COLUMNS = 10 * WIDTH;

std::size_t countStrips(std::size_t numRows)
{
    return (numRows + WIDTH - 1) / WIDTH;
}

/** The place of a strip in the factor: the first ones have only the columns up to the diagonal. */
std::size_t findStripStart(std::size_t strip, std::size_t numColumns)
{
    const std::size_t numTriangular = std::min(strip, numColumns / WIDTH);
    return TILE * (numTriangular * (numTriangular + 1) / 2) + (strip - numTriangular) * WIDTH * numColumns;
}

/** Call a function for each number, in several threads if that is worth it. @param work of all calls. */
template <class Function>
void forEach(std::size_t first, std::size_t end, std::size_t work, const Function& function)
{
    if (work >= LEAST_PARALLEL_WORK)
        return forEachIndex(end - first, [&](std::size_t index) { function(first + index); });
    for (std::size_t index = first; index < end; ++index)
        function(index);
}

} // namespace

Front::Front(std::size_t numColumns, std::size_t numRows, double* factor, double* rest) :
    _numColumns(numColumns), _numStrips(countStrips(numRows)), _factor(factor), _rest(rest)
{
}

std::size_t Front::getFactorSize(std::size_t numColumns, std::size_t numRows)
{
    return findStripStart(countStrips(numRows), numColumns);
}

std::size_t Front::getRestSize(std::size_t numColumns, std::size_t numRows)
{
    if (numColumns == numRows) return 0;
    const std::size_t numStrips = countStrips(numRows) - numColumns / WIDTH;
    return TILE * (numStrips * (numStrips + 1) / 2);
}

double* Front::getStrip(std::size_t strip) const
{
    return _factor + findStripStart(strip, _numColumns);
}

double* Front::getTile(std::size_t row, std::size_t column) const
{
    const std::size_t first = _numColumns / WIDTH;
    const std::size_t index = column - first;
    return _rest + TILE * (index * (_numStrips - first) - index * (index + 1) / 2 + row - first);
}

double* Front::findBlock(std::size_t row, std::size_t column) const
{
    const std::size_t strip = 6 * row / WIDTH;
    const std::size_t place = 6 * row % WIDTH;
    const std::size_t firstColumn = 6 * column;
    if (firstColumn < _numColumns) return getStrip(strip) + firstColumn * WIDTH + place;
    return getTile(strip, firstColumn / WIDTH) + firstColumn % WIDTH * WIDTH + place;
}

/** Eliminate up to 24 columns, after subtracting the products of those before. */
void Front::factorizePanel(std::size_t panel, const double* leastPivots, double* reciprocals) const
{
    const std::size_t first = panel * WIDTH;
    const std::size_t count = std::min(WIDTH, _numColumns - first);
    const StripKernels& kernels = StripKernels::get();
    const auto subtract = [&](std::size_t strip)
    {
        double* result = getStrip(strip) + first * WIDTH;
        if (count == WIDTH) return kernels.subtractProduct(getStrip(strip), getStrip(panel), first, result);
        std::array<double, TILE> tile{};
        std::copy(result, result + count * WIDTH, tile.begin());
        kernels.subtractProduct(getStrip(strip), getStrip(panel), first, tile.data());
        std::copy(tile.begin(), tile.begin() + static_cast<std::ptrdiff_t>(count * WIDTH), result);
    };
    if (first > 0) subtract(panel);
    double* triangle = getStrip(panel) + first * WIDTH;
    kernels.factorize(triangle, count, leastPivots + first, reciprocals + first);
    forEach(panel + 1, _numStrips, (_numStrips - panel - 1) * TILE * (first + WIDTH / 2),
            [&](std::size_t strip)
            {
                if (first > 0) subtract(strip);
                kernels.divide(triangle, reciprocals + first, count, getStrip(strip) + first * WIDTH);
            });
}

bool Front::factorize(const double* leastPivots, double* reciprocals, const std::function<bool()>& mustStop) const
{
    for (std::size_t panel = 0; panel * WIDTH < _numColumns; ++panel)
    {
        if (mustStop()) return false;
        factorizePanel(panel, leastPivots, reciprocals);
    }
    if (!_rest) return true;
    const std::size_t numStrips = _numStrips - _numColumns / WIDTH;
    const StripKernels& kernels = StripKernels::get();
    std::atomic<bool> hasStopped = false;
    forEach(_numColumns / WIDTH, _numStrips, numStrips * numStrips / 2 * TILE * _numColumns,
            [&](std::size_t column)
            {
                for (std::size_t first = 0; first < _numColumns; first += NUM_CACHED_COLUMNS)
                {
                    if (hasStopped || (first > 0 && mustStop()))
                    {
                        hasStopped = true;
                        return;
                    }
                    const std::size_t count = std::min(NUM_CACHED_COLUMNS, _numColumns - first);
                    for (std::size_t row = column; row < _numStrips; ++row)
                        kernels.subtractProduct(getStrip(row) + first * WIDTH, getStrip(column) + first * WIDTH, count,
                                                getTile(row, column));
                }
            });
    return !hasStopped;
}

void Front::solveForwards(const double* reciprocals, double* rows) const
{
    const StripKernels& kernels = StripKernels::get();
    for (std::size_t panel = 0; panel * WIDTH < _numColumns; ++panel)
    {
        const std::size_t first = panel * WIDTH;
        double* values = rows + first;
        kernels.subtractVector(getStrip(panel), first, rows, values);
        for (std::size_t column = first; column < std::min(first + WIDTH, _numColumns); ++column)
        {
            // The upper triangle of the strip is 0.
            const double* factors = getStrip(panel) + column * WIDTH;
            const double value = rows[column] * reciprocals[column];
            for (std::size_t row = 0; row < WIDTH; ++row)
                values[row] -= factors[row] * value;
            rows[column] = value;
        }
    }
    const std::size_t end = countStrips(_numColumns);
    forEach(end, _numStrips, (_numStrips - end) * WIDTH * _numColumns,
            [&](std::size_t strip)
            { kernels.subtractVector(getStrip(strip), _numColumns, rows, rows + strip * WIDTH); });
}

void Front::solveBackwards(const double* reciprocals, double* rows) const
{
    const StripKernels& kernels = StripKernels::get();
    const std::size_t end = countStrips(_numColumns);
    const std::size_t numParts = (_numColumns + NUM_CACHED_COLUMNS - 1) / NUM_CACHED_COLUMNS;
    forEach(0, numParts, (_numStrips - end) * WIDTH * _numColumns,
            [&](std::size_t part)
            {
                const std::size_t first = part * NUM_CACHED_COLUMNS;
                const std::size_t count = std::min(NUM_CACHED_COLUMNS, _numColumns - first);
                for (std::size_t strip = end; strip < _numStrips; ++strip)
                    kernels.subtractTransposed(getStrip(strip) + first * WIDTH, count, rows + strip * WIDTH,
                                               rows + first);
            });
    for (std::size_t panel = end; panel-- > 0;)
    {
        const std::size_t first = panel * WIDTH;
        const double* values = rows + first;
        for (std::size_t column = std::min(first + WIDTH, _numColumns); column-- > first;)
        {
            const double* factors = getStrip(panel) + column * WIDTH;
            double sum = rows[column];
            for (std::size_t row = column - first + 1; row < WIDTH; ++row)
                sum -= factors[row] * values[row];
            rows[column] = sum * reciprocals[column];
        }
        kernels.subtractTransposed(getStrip(panel), first, values, rows);
    }
}

} // namespace osgLego
