#include <osgLego/stability/EliminationTree.h>

#include <algorithm>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace osgLego
{

namespace
{

using MatrixPlaces = std::span<const std::pair<std::int32_t, std::int32_t>>;

std::vector<std::uint32_t> chooseOrder(std::size_t numBlocks, MatrixPlaces places)
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

/** Whether zeros in joined columns cost less than the work with fewer, larger matrices saves. */
bool isWorthJoining(std::size_t numColumns, double shareOfZeros)
{
    if (numColumns <= 4) return shareOfZeros < 0.6;
    if (numColumns <= 12) return shareOfZeros < 0.2;
    return shareOfZeros < 0.05;
}

} // namespace

EliminationTree::EliminationTree(std::size_t numBlocks, MatrixPlaces places, const std::function<bool()>& isCancelled) :
    _ranks(chooseOrder(numBlocks, places)), _supernodeOfRank(numBlocks)
{
    Columns columns(numBlocks);
    for (const auto& [row, column] : places)
    {
        const auto ends = std::minmax(_ranks[static_cast<std::size_t>(row)], _ranks[static_cast<std::size_t>(column)]);
        columns[ends.first].push_back(ends.second);
    }
    for (std::vector<std::uint32_t>& rows : columns)
    {
        if (isCancelled && isCancelled()) return;
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        // The first row below the diagonal is the parent in the elimination tree, which gets all others.
        if (rows.size() > 1) columns[rows[0]].insert(columns[rows[0]].end(), rows.begin() + 1, rows.end());
    }
    sortChildrenFirst(columns);
    joinColumns(columns);
    connect();
}

/** Change the order so that all descendants of a column are just before it, which fills no more places. */
void EliminationTree::sortChildrenFirst(Columns& columns)
{
    const auto count = static_cast<std::uint32_t>(columns.size());
    Columns children(count + std::size_t(1)); // the last element has the roots
    for (std::uint32_t column = 0; column < count; ++column)
        children[columns[column].empty() ? count : columns[column][0]].push_back(column);
    std::vector<std::uint32_t> newRanks(count);
    std::vector<std::uint32_t> waiting;
    const auto addChildren = [&](std::uint32_t parent)
    {
        // The child with the most rows is the last, since it is the one that its parent can be joined with.
        std::vector<std::uint32_t>& siblings = children[parent];
        std::stable_sort(siblings.begin(), siblings.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return columns[a].size() < columns[b].size(); });
        waiting.insert(waiting.end(), siblings.begin(), siblings.end());
    };
    addChildren(count);
    for (std::uint32_t rank = count; !waiting.empty();)
    {
        const std::uint32_t column = waiting.back();
        waiting.pop_back();
        newRanks[column] = --rank;
        addChildren(column);
    }
    Columns sorted(count);
    for (std::uint32_t column = 0; column < count; ++column)
    {
        for (std::uint32_t& row : columns[column])
            row = newRanks[row];
        std::sort(columns[column].begin(), columns[column].end());
        sorted[newRanks[column]] = std::move(columns[column]);
    }
    columns = std::move(sorted);
    for (std::uint32_t& rank : _ranks)
        rank = newRanks[rank];
}

void EliminationTree::joinColumns(Columns& columns)
{
    std::vector<std::size_t> numEntries; // of each supernode, without zeros
    for (std::uint32_t column = 0; column < columns.size(); ++column)
    {
        Supernode joined;
        joined.first = column;
        joined.numColumns = 1;
        joined.rows = std::move(columns[column]);
        std::size_t entries = 1 + joined.rows.size();
        while (!_supernodes.empty())
        {
            const Supernode& previous = _supernodes.back();
            // Only a child can be joined; as the last of its children, it is just before the parent.
            if (previous.rows.empty() || previous.rows[0] > column) break;
            const std::size_t numColumns = previous.numColumns + joined.numColumns;
            const std::size_t size = numColumns * (numColumns + 1) / 2 + numColumns * joined.rows.size();
            const std::size_t sum = entries + numEntries.back();
            if (!isWorthJoining(numColumns, static_cast<double>(size - sum) / static_cast<double>(size))) break;
            joined.first = previous.first;
            joined.numColumns = static_cast<std::uint32_t>(numColumns);
            entries = sum;
            _supernodes.pop_back();
            numEntries.pop_back();
        }
        _supernodes.push_back(std::move(joined));
        numEntries.push_back(entries);
    }
}

void EliminationTree::connect()
{
    const auto count = static_cast<std::uint32_t>(_supernodes.size());
    for (std::uint32_t index = 0; index < count; ++index)
        for (std::uint32_t column = 0; column < _supernodes[index].numColumns; ++column)
            _supernodeOfRank[_supernodes[index].first + column] = index;
    for (std::uint32_t index = 0; index < count; ++index)
    {
        Supernode& supernode = _supernodes[index];
        for (std::size_t column = 0; column < supernode.numColumns; ++column)
        {
            const auto numRows = static_cast<double>(supernode.getNumRows() - column);
            supernode.work += 0.5 * numRows * numRows;
        }
        supernode.firstDescendant =
            supernode.children.empty() ? index : _supernodes[supernode.children[0]].firstDescendant;
        if (supernode.rows.empty()) continue;
        supernode.parent = _supernodeOfRank[supernode.rows[0]];
        _supernodes[supernode.parent].children.push_back(index);
        _supernodes[supernode.parent].work += supernode.work;
        for (const std::uint32_t row : supernode.rows)
            supernode.targets.push_back(findTarget(supernode.parent, row));
    }
}

std::uint32_t EliminationTree::findTarget(std::uint32_t supernode, std::uint32_t rank) const
{
    const Supernode& target = _supernodes[supernode];
    if (rank < target.first + target.numColumns) return rank - target.first;
    const auto place = std::lower_bound(target.rows.begin(), target.rows.end(), rank);
    return target.numColumns + static_cast<std::uint32_t>(place - target.rows.begin());
}

} // namespace osgLego
