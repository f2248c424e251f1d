#include <osgLego/stability/BlockCholesky.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace osgLego
{

namespace
{

using Block = BlockCholesky::Block;

// A pivot that has lost this share of its value counts as 0.
constexpr double LEAST_PIVOT = 1e-18;
// Replaces such a pivot, so that the solution is 0 there.
constexpr double INFINITE_PIVOT = 1e100;

/** Replace the lower triangle of a block by its Cholesky factor. @param original the block before elimination. */
void factorizeBlock(Block& block, const Eigen::Matrix<double, 6, 1>& original)
{
    for (int column = 0; column < 6; ++column)
    {
        double pivot = block(column, column);
        for (int k = 0; k < column; ++k)
            pivot -= block(column, k) * block(column, k);
        if (!(pivot > LEAST_PIVOT * original[column])) pivot = INFINITE_PIVOT;
        const double root = std::sqrt(pivot);
        block(column, column) = root;
        for (int row = column + 1; row < 6; ++row)
        {
            double value = block(row, column);
            for (int k = 0; k < column; ++k)
                value -= block(row, k) * block(column, k);
            block(row, column) = value / root;
        }
    }
}

std::vector<std::uint32_t> chooseOrder(std::size_t numBlocks,
                                       std::span<const std::pair<std::int32_t, std::int32_t>> places)
{
    using Pattern = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
    std::vector<Eigen::Triplet<double, int>> entries;
    for (const auto& [row, column] : places)
    {
        entries.emplace_back(row, column, 1.0);
        entries.emplace_back(column, row, 1.0);
    }
    const auto size = static_cast<Eigen::Index>(numBlocks);
    for (int row = 0; row < size; ++row)
        entries.emplace_back(row, row, 1.0);
    Pattern pattern(size, size);
    pattern.setFromTriplets(entries.begin(), entries.end());
    Eigen::AMDOrdering<int>::PermutationType order;
    Eigen::AMDOrdering<int>()(pattern, order);
    std::vector<std::uint32_t> ranks(numBlocks);
    for (Eigen::Index rank = 0; rank < size; ++rank)
        ranks[static_cast<std::size_t>(order.indices()[rank])] = static_cast<std::uint32_t>(rank);
    return ranks;
}

} // namespace

BlockCholesky::BlockCholesky(std::size_t numBlocks, std::span<const std::pair<std::int32_t, std::int32_t>> places,
                             std::function<bool()> isCancelled) :
    _isCancelled(std::move(isCancelled)),
    _ranks(chooseOrder(numBlocks, places)), _diagonal(numBlocks), _scatter(numBlocks)
{
    analyze(numBlocks, places);
}

bool BlockCholesky::mustStop()
{
    _hasBeenCancelled = _hasBeenCancelled || (_isCancelled && _isCancelled());
    return _hasBeenCancelled;
}

void BlockCholesky::analyze(std::size_t numBlocks, std::span<const std::pair<std::int32_t, std::int32_t>> places)
{
    std::vector<std::vector<std::uint32_t>> columns(numBlocks);
    for (const auto& [row, column] : places)
    {
        const auto ends = std::minmax(_ranks[static_cast<std::size_t>(row)], _ranks[static_cast<std::size_t>(column)]);
        columns[ends.first].push_back(ends.second);
    }
    _starts.assign(1, 0);
    for (std::size_t column = 0; column < numBlocks; ++column)
    {
        if (mustStop()) return;
        std::vector<std::uint32_t>& rows = columns[column];
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        // The first row below the diagonal is the parent in the elimination tree, which gets all others.
        if (rows.size() > 1) columns[rows[0]].insert(columns[rows[0]].end(), rows.begin() + 1, rows.end());
        _rows.insert(_rows.end(), rows.begin(), rows.end());
        _starts.push_back(_rows.size());
    }
    _blocks.resize(_rows.size());
    _rowStarts.assign(numBlocks + 1, 0);
    for (const std::uint32_t row : _rows)
        ++_rowStarts[row + 1];
    for (std::size_t row = 0; row < numBlocks; ++row)
        _rowStarts[row + 1] += _rowStarts[row];
    _rowBlocks.resize(_rows.size());
    std::vector<std::size_t> ends(_rowStarts.begin(), _rowStarts.end() - 1);
    for (std::uint32_t column = 0; column < numBlocks; ++column)
        for (std::size_t index = _starts[column]; index < _starts[column + 1]; ++index)
            _rowBlocks[ends[_rows[index]]++] = {column, index};
    for (const auto& [row, column] : places)
    {
        const std::uint32_t rowRank = _ranks[static_cast<std::size_t>(row)];
        const std::uint32_t columnRank = _ranks[static_cast<std::size_t>(column)];
        const auto ranks = std::minmax(rowRank, columnRank);
        const auto first = _rows.begin() + static_cast<std::ptrdiff_t>(_starts[ranks.first]);
        const auto end = _rows.begin() + static_cast<std::ptrdiff_t>(_starts[ranks.first + 1]);
        _targets.push_back(static_cast<std::size_t>(std::lower_bound(first, end, ranks.second) - _rows.begin()));
        _isTransposed.push_back(rowRank < columnRank);
    }
}

void BlockCholesky::setZero()
{
    std::fill(_diagonal.begin(), _diagonal.end(), Block::Zero());
    std::fill(_blocks.begin(), _blocks.end(), Block::Zero());
}

void BlockCholesky::addBlock(std::size_t place, const Block& block)
{
    if (_isTransposed[place])
        _blocks[_targets[place]] += block.transpose();
    else
        _blocks[_targets[place]] += block;
}

void BlockCholesky::factorize()
{
    for (std::size_t column = 0; column < _diagonal.size(); ++column)
    {
        if (mustStop()) return;
        Block& diagonal = _diagonal[column];
        const Eigen::Matrix<double, 6, 1> original = diagonal.diagonal();
        for (std::size_t index = _starts[column]; index < _starts[column + 1]; ++index)
            _scatter[_rows[index]] = index;
        for (std::size_t entry = _rowStarts[column]; entry < _rowStarts[column + 1]; ++entry)
        {
            const auto& [previous, first] = _rowBlocks[entry];
            const Block factor = _blocks[first].transpose();
            diagonal.noalias() -= _blocks[first].lazyProduct(factor);
            for (std::size_t index = first + 1; index < _starts[previous + 1]; ++index)
                _blocks[_scatter[_rows[index]]].noalias() -= _blocks[index].lazyProduct(factor);
        }
        factorizeBlock(diagonal, original);
        for (std::size_t index = _starts[column]; index < _starts[column + 1]; ++index)
            diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(_blocks[index]);
    }
}

void BlockCholesky::solve(Eigen::VectorXd& vector) const
{
    Eigen::VectorXd permuted(vector.size());
    for (std::size_t row = 0; row < _ranks.size(); ++row)
        permuted.segment<6>(6 * static_cast<Eigen::Index>(_ranks[row])) =
            vector.segment<6>(6 * static_cast<Eigen::Index>(row));
    const auto segmentOf = [&](std::size_t rank) { return permuted.segment<6>(6 * static_cast<Eigen::Index>(rank)); };
    for (std::size_t column = 0; column < _diagonal.size(); ++column)
    {
        auto place = segmentOf(column);
        _diagonal[column].triangularView<Eigen::Lower>().solveInPlace(place);
        for (std::size_t index = _starts[column]; index < _starts[column + 1]; ++index)
            segmentOf(_rows[index]) -= _blocks[index] * place;
    }
    for (std::size_t column = _diagonal.size(); column-- > 0;)
    {
        auto place = segmentOf(column);
        for (std::size_t index = _starts[column]; index < _starts[column + 1]; ++index)
            place -= _blocks[index].transpose() * segmentOf(_rows[index]);
        _diagonal[column].triangularView<Eigen::Lower>().transpose().solveInPlace(place);
    }
    for (std::size_t row = 0; row < _ranks.size(); ++row)
        vector.segment<6>(6 * static_cast<Eigen::Index>(row)) =
            permuted.segment<6>(6 * static_cast<Eigen::Index>(_ranks[row]));
}

} // namespace osgLego
