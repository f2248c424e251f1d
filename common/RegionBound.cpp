#include "RegionBound.h"

#include <osgLego/PartType.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include <CbcEventHandler.hpp>
#include <CbcModel.hpp>
#include <CbcSolver.hpp>
#include <CoinPackedMatrix.hpp>
#include <CoinTime.hpp>
#include <OsiClpSolverInterface.hpp>

namespace osgLego
{

namespace
{

// Objectives are whole numbers; solvers return them with errors of about 1e-7.
constexpr double TOLERANCE = 1e-5;

std::size_t roundUp(double objective)
{
    return static_cast<std::size_t>(std::max(std::ceil(objective - TOLERANCE), 0.0));
}

/** All parts that fit into some cells of one layer, as the columns of a matrix whose rows are the cells. */
class PartColumns
{
public:
    PartColumns(const std::vector<LayoutCell>& cells, const std::vector<LayoutColor>& colors) :
        _cells(cells), _colors(colors)
    {
        for (std::size_t row = 0; row < cells.size(); ++row)
            _rows.emplace(std::array{cells[row].place[0], cells[row].place[1]}, static_cast<int>(row));
        for (const LayoutCell& cell : cells)
            addPartsAt(cell);
        addMissing();
    }

    int getNumColumns() const { return static_cast<int>(starts.size()) - 1; }

    std::vector<CoinBigIndex> starts{0}; //!< the first of the `rows` of each column
    std::vector<int> rows;

private:
    void addPartsAt(const LayoutCell& cell)
    {
        for (std::size_t size = 0; size < PART_SIZES.size(); ++size)
        {
            const auto [width, length] = PART_SIZES[size];
            addPart(cell, width, length, size);
            if (width != length) addPart(cell, length, width, size);
        }
    }

    /** Add the part whose lowest cell is given, unless it doesn't fit. */
    void addPart(const LayoutCell& cell, int width, int length, std::size_t size)
    {
        std::uint16_t color = LayoutCell::ANY_COLOR;
        const std::size_t before = rows.size();
        for (int y = 0; y < length; ++y)
            for (int x = 0; x < width; ++x)
                if (!addRow(cell.place[0] + x, cell.place[1] + y, color))
                {
                    rows.resize(before);
                    return;
                }
        if (isAvailable(color, size))
            starts.push_back(static_cast<CoinBigIndex>(rows.size()));
        else
            rows.resize(before);
    }

    bool addRow(int x, int y, std::uint16_t& color)
    {
        const auto row = _rows.find({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
        if (row == _rows.end()) return false;
        const std::uint16_t other = _cells[static_cast<std::size_t>(row->second)].color;
        if (color == LayoutCell::ANY_COLOR) color = other;
        if (other != LayoutCell::ANY_COLOR && other != color) return false;
        rows.push_back(row->second);
        return true;
    }

    bool isAvailable(std::uint16_t color, std::size_t size) const
    {
        const auto hasSize = [size](const LayoutColor& candidate) { return (candidate.bricks >> size & 1) != 0; };
        return color == LayoutCell::ANY_COLOR ? std::any_of(_colors.begin(), _colors.end(), hasSize)
                                              : hasSize(_colors[color]);
    }

    /** Let a part cover each cell by itself, so that there is a solution, even if 1x1 was never made in its colour. */
    void addMissing()
    {
        for (std::size_t row = 0; row < _cells.size(); ++row)
            if (!isAvailable(_cells[row].color, 0))
            {
                rows.push_back(static_cast<int>(row));
                starts.push_back(static_cast<CoinBigIndex>(rows.size()));
            }
    }

    const std::vector<LayoutCell>& _cells;
    const std::vector<LayoutColor>& _colors;
    std::map<std::array<std::uint16_t, 2>, int> _rows;
};

/** Ends a search early. */
class Cancellation : public CbcEventHandler
{
public:
    explicit Cancellation(const std::function<bool()>& isCancelled) : _isCancelled(isCancelled) {}

    CbcAction event(CbcEvent) override { return _isCancelled && _isCancelled() ? stop : noAction; }
    CbcEventHandler* clone() const override { return new Cancellation(*this); }

private:
    const std::function<bool()>& _isCancelled;
};

void load(OsiClpSolverInterface& solver, const PartColumns& columns, std::size_t numCells)
{
    const int numRows = static_cast<int>(numCells);
    const std::vector<double> elements(columns.rows.size(), 1.0);
    const CoinPackedMatrix matrix(true, numRows, columns.getNumColumns(),
                                  static_cast<CoinBigIndex>(columns.rows.size()), elements.data(), columns.rows.data(),
                                  columns.starts.data(), nullptr);
    const auto numColumns = static_cast<std::size_t>(columns.getNumColumns());
    const std::vector<double> zeros(numColumns, 0.0);
    const std::vector<double> ones(std::max(numColumns, numCells), 1.0);
    solver.messageHandler()->setLogLevel(0);
    solver.getModelPtr()->messageHandler()->setLogLevel(0);
    solver.loadProblem(matrix, zeros.data(), ones.data(), ones.data(), ones.data(), ones.data());
    for (int column = 0; column < columns.getNumColumns(); ++column)
        solver.setInteger(column);
}

bool isIntegral(const OsiClpSolverInterface& solver)
{
    const double* values = solver.getColSolution();
    return std::all_of(values, values + solver.getNumCols(),
                       [](double value) { return std::abs(value - std::round(value)) < TOLERANCE; });
}

int continueAlways(CbcModel*, int)
{
    return 0;
}

RegionBound branch(const OsiClpSolverInterface& solver, std::size_t bound, double seconds,
                   const std::function<bool()>& isCancelled)
{
    CbcModel model(solver);
    model.setLogLevel(0);
    const Cancellation cancellation(isCancelled);
    model.passInEventHandler(&cancellation);
    CbcSolverUsefulData data;
    data.useSignalHandler_ = false;
    data.noPrinting_ = true;
    CbcMain0(model, data);
    model.setLogLevel(0);
    const std::string limit = std::to_string(seconds);
    std::array arguments{"cbc",     "-logLevel", "0",           "-slogLevel", "0",    "-timeMode",
                         "elapsed", "-seconds",  limit.c_str(), "-solve",     "-quit"};
    CbcMain1(static_cast<int>(arguments.size()), arguments.data(), model, continueAlways, data);
    if (model.isProvenOptimal()) return {roundUp(model.getObjValue()), true};
    return {std::max(bound, roundUp(model.getBestPossibleObjValue())), false};
}

/** A bound that needs no search: each cell costs the share that it has in the largest part that could cover it. */
double computeShares(const PartColumns& columns, std::size_t numCells)
{
    std::vector<double> shares(numCells, 1.0);
    for (std::size_t column = 0; column + 1 < columns.starts.size(); ++column)
    {
        const auto begin = static_cast<std::size_t>(columns.starts[column]);
        const auto end = static_cast<std::size_t>(columns.starts[column + 1]);
        for (std::size_t entry = begin; entry < end; ++entry)
        {
            double& share = shares[static_cast<std::size_t>(columns.rows[entry])];
            share = std::min(share, 1.0 / static_cast<double>(end - begin));
        }
    }
    double sum = 0.0;
    for (const double share : shares)
        sum += share;
    return sum;
}

} // namespace

RegionBound boundRegion(const std::vector<LayoutCell>& cells, const std::vector<LayoutColor>& colors, double seconds,
                        const std::function<bool()>& isCancelled)
{
    if (cells.size() == 1) return {1, true};
    const PartColumns columns(cells, colors);
    OsiClpSolverInterface solver;
    load(solver, columns, cells.size());
    const double start = CoinGetTimeOfDay();
    solver.getModelPtr()->setMaximumWallSeconds(seconds);
    solver.initialSolve();
    if (!solver.isProvenOptimal()) return {roundUp(computeShares(columns, cells.size())), false};
    const std::size_t bound = roundUp(solver.getObjValue());
    if (isIntegral(solver)) return {bound, true};
    solver.getModelPtr()->setMaximumWallSeconds(-1.0);
    const double rest = seconds - (CoinGetTimeOfDay() - start);
    if (rest <= 0.0 || (isCancelled && isCancelled())) return {bound, false};
    return branch(solver, bound, rest, isCancelled);
}

} // namespace osgLego
