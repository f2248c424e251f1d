#include <osgLego/stability/BlockCholesky.h>

#include <osgLego/data/ParallelLoop.h>
#include <osgLego/stability/StripKernels.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace osgLego
{

namespace
{

using Block = BlockCholesky::Block;

constexpr std::size_t ROWS = 6;
constexpr std::size_t STRIDE = StripKernels::NUM_ROWS; // between columns
// A pivot that has lost all but this share of its value consists of rounding errors, and is replaced by this share. So
// rounding errors do not decide whether a pivot counts as 0, and conjugate gradients correct the difference.
constexpr double LEAST_PIVOT = 1e-14;
// Independent subtrees have at most this share of the work, and the whole tree at least this many products of blocks.
constexpr double SUBTREE_SHARE = 1.0 / 32.0;
constexpr double LEAST_PARALLEL_BLOCKS = 10'000.0;

} // namespace

BlockCholesky::BlockCholesky(std::size_t numBlocks, std::span<const std::pair<std::int32_t, std::int32_t>> places,
                             std::function<bool()> isCancelled) :
    _isCancelled(std::move(isCancelled)),
    _tree(numBlocks, places, [this] { return mustStop(); }), _diagonal(numBlocks), _blocks(places.size()),
    _reciprocals(ROWS * numBlocks), _leastPivots(ROWS * numBlocks)
{
    if (_hasBeenCancelled) return;
    listEntries(places);
    chooseSubtrees();
    std::size_t size = 0;
    for (const EliminationTree::Supernode& supernode : _tree.getSupernodes())
    {
        _starts.push_back(size);
        size += Front::getFactorSize(ROWS * supernode.numColumns, ROWS * supernode.getNumRows());
    }
    _factor.resize(size);
    _rests.resize(_starts.size());
}

bool BlockCholesky::mustStop()
{
    const std::atomic_ref hasBeenCancelled(_hasBeenCancelled);
    if (!hasBeenCancelled && _isCancelled && _isCancelled()) hasBeenCancelled = true;
    return hasBeenCancelled;
}

void BlockCholesky::listEntries(std::span<const std::pair<std::int32_t, std::int32_t>> places)
{
    _entries.resize(_tree.getSupernodes().size());
    for (std::size_t place = 0; place < places.size(); ++place)
    {
        const std::uint32_t row = _tree.getRanks()[static_cast<std::size_t>(places[place].first)];
        const std::uint32_t column = _tree.getRanks()[static_cast<std::size_t>(places[place].second)];
        const std::uint32_t supernode = _tree.findSupernode(std::min(row, column));
        _entries[supernode].push_back({place, _tree.findTarget(supernode, std::max(row, column)),
                                       _tree.findTarget(supernode, std::min(row, column)), row < column});
    }
}

void BlockCholesky::chooseSubtrees()
{
    const std::vector<EliminationTree::Supernode>& supernodes = _tree.getSupernodes();
    double total = 0.0;
    for (const EliminationTree::Supernode& supernode : supernodes)
        if (supernode.parent == EliminationTree::NONE) total += supernode.work;
    const double most = total < LEAST_PARALLEL_BLOCKS ? -1.0 : SUBTREE_SHARE * total;
    for (std::uint32_t index = 0; index < supernodes.size(); ++index)
        if (supernodes[index].work > most)
            _others.push_back(index);
        else if (supernodes[index].parent == EliminationTree::NONE || supernodes[supernodes[index].parent].work > most)
            _subtrees.push_back(index);
}

template <class Function>
void BlockCholesky::forEachUpwards(const Function& function) const
{
    forEachIndex(_subtrees.size(),
                 [&](std::size_t subtree)
                 {
                     const std::uint32_t root = _subtrees[subtree];
                     for (std::uint32_t index = _tree.getSupernodes()[root].firstDescendant; index <= root; ++index)
                         function(index);
                 });
    for (const std::uint32_t index : _others)
        function(index);
}

void BlockCholesky::setZero()
{
    std::fill(_diagonal.begin(), _diagonal.end(), Block::Zero());
    std::fill(_blocks.begin(), _blocks.end(), Block::Zero());
}

Front BlockCholesky::getFront(std::size_t index, double* rest) const
{
    const EliminationTree::Supernode& supernode = _tree.getSupernodes()[index];
    return {ROWS * supernode.numColumns, ROWS * supernode.getNumRows(), _factor.data() + _starts[index], rest};
}

void BlockCholesky::factorize()
{
    for (std::size_t rank = 0; rank < _diagonal.size(); ++rank)
        for (std::size_t row = 0; row < ROWS; ++row)
        {
            const auto place = static_cast<Eigen::Index>(row);
            _leastPivots[ROWS * rank + row] = LEAST_PIVOT * _diagonal[rank](place, place);
        }
    forEachUpwards([&](std::size_t index) { factorize(index); });
}

void BlockCholesky::factorize(std::size_t index)
{
    if (mustStop()) return;
    const EliminationTree::Supernode& supernode = _tree.getSupernodes()[index];
    const std::size_t numColumns = ROWS * supernode.numColumns;
    const std::size_t numRows = ROWS * supernode.getNumRows();
    const auto factor = _factor.begin() + static_cast<std::ptrdiff_t>(_starts[index]);
    std::fill_n(factor, Front::getFactorSize(numColumns, numRows), 0.0);
    Numbers& rest = _rests[index];
    rest.assign(Front::getRestSize(numColumns, numRows), 0.0);
    const Front front = getFront(index, rest.empty() ? nullptr : rest.data());
    addEntries(index, front);
    for (const std::uint32_t child : supernode.children)
    {
        if (mustStop()) return;
        addRest(child, front);
        Numbers().swap(_rests[child]); // frees it, unlike an assignment
    }
    front.factorize(_leastPivots.data() + ROWS * supernode.first, _reciprocals.data() + ROWS * supernode.first,
                    [this] { return mustStop(); });
}

void BlockCholesky::addEntries(std::size_t index, const Front& front)
{
    using Place = Eigen::Map<Block, Eigen::Unaligned, Eigen::OuterStride<STRIDE>>;
    const EliminationTree::Supernode& supernode = _tree.getSupernodes()[index];
    for (std::size_t column = 0; column < supernode.numColumns; ++column)
        Place(front.findBlock(column, column)) += _diagonal[supernode.first + column];
    for (const Entry& entry : _entries[index])
    {
        Place place(front.findBlock(entry.row, entry.column));
        if (entry.isTransposed)
            place += _blocks[entry.place].transpose();
        else
            place += _blocks[entry.place];
    }
}

void BlockCholesky::addRest(std::size_t child, const Front& front)
{
    const EliminationTree::Supernode& supernode = _tree.getSupernodes()[child];
    const Front source = getFront(child, _rests[child].data());
    const std::vector<std::uint32_t>& targets = supernode.targets;
    for (std::size_t column = 0; column < targets.size(); ++column)
        for (std::size_t row = column; row < targets.size(); ++row)
        {
            const double* from = source.findBlock(supernode.numColumns + row, supernode.numColumns + column);
            double* to = front.findBlock(targets[row], targets[column]);
            for (std::size_t place = 0; place < ROWS; ++place, from += STRIDE, to += STRIDE)
                for (std::size_t number = 0; number < ROWS; ++number)
                    to[number] += from[number];
        }
}

void BlockCholesky::solve(Eigen::VectorXd& vector) const
{
    Eigen::VectorXd permuted(vector.size());
    const std::vector<std::uint32_t>& ranks = _tree.getRanks();
    for (std::size_t row = 0; row < ranks.size(); ++row)
        permuted.segment<6>(6 * static_cast<Eigen::Index>(ranks[row])) =
            vector.segment<6>(6 * static_cast<Eigen::Index>(row));
    std::vector<Numbers> shares(_starts.size());
    forEachUpwards([&](std::size_t index) { solveForwards(index, permuted, shares); });
    for (auto index = _others.rbegin(); index != _others.rend(); ++index)
        solveBackwards(*index, permuted);
    forEachIndex(_subtrees.size(),
                 [&](std::size_t subtree)
                 {
                     const std::uint32_t root = _subtrees[subtree];
                     for (std::uint32_t index = root + 1; index-- > _tree.getSupernodes()[root].firstDescendant;)
                         solveBackwards(index, permuted);
                 });
    for (std::size_t row = 0; row < ranks.size(); ++row)
        vector.segment<6>(6 * static_cast<Eigen::Index>(row)) =
            permuted.segment<6>(6 * static_cast<Eigen::Index>(ranks[row]));
}

BlockCholesky::Numbers BlockCholesky::startRows(const Front& front, std::span<const double> values)
{
    Numbers rows(STRIDE * front.getNumStrips(), 0.0);
    std::copy(values.begin(), values.end(), rows.begin());
    return rows;
}

/** @param shares for each supernode, the numbers that its elimination adds to the rows below its columns. */
void BlockCholesky::solveForwards(std::size_t index, Eigen::VectorXd& vector, std::vector<Numbers>& shares) const
{
    const EliminationTree::Supernode& supernode = _tree.getSupernodes()[index];
    const Front front = getFront(index, nullptr);
    const std::size_t numColumns = ROWS * supernode.numColumns;
    double* values = vector.data() + ROWS * supernode.first;
    Numbers rows = startRows(front, {values, numColumns});
    for (const std::uint32_t child : supernode.children)
    {
        const std::vector<std::uint32_t>& targets = _tree.getSupernodes()[child].targets;
        for (std::size_t row = 0; row < targets.size(); ++row)
            for (std::size_t number = 0; number < ROWS; ++number)
                rows[ROWS * targets[row] + number] += shares[child][ROWS * row + number];
        Numbers().swap(shares[child]);
    }
    front.solveForwards(_reciprocals.data() + ROWS * supernode.first, rows.data());
    std::copy(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(numColumns), values);
    shares[index].assign(rows.begin() + static_cast<std::ptrdiff_t>(numColumns), rows.end());
}

void BlockCholesky::solveBackwards(std::size_t index, Eigen::VectorXd& vector) const
{
    const EliminationTree::Supernode& supernode = _tree.getSupernodes()[index];
    const Front front = getFront(index, nullptr);
    const std::size_t numColumns = ROWS * supernode.numColumns;
    double* values = vector.data() + ROWS * supernode.first;
    Numbers rows = startRows(front, {values, numColumns});
    for (std::size_t row = 0; row < supernode.rows.size(); ++row)
        std::copy_n(vector.data() + ROWS * supernode.rows[row], ROWS, rows.data() + numColumns + ROWS * row);
    front.solveBackwards(_reciprocals.data() + ROWS * supernode.first, rows.data());
    std::copy(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(numColumns), values);
}

} // namespace osgLego
