#pragma once

#include <osgLego/stability/EliminationTree.h>
#include <osgLego/stability/Front.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <tbb/cache_aligned_allocator.h>

namespace osgLego
{

/** Factorizes symmetric positive definite matrices of blocks of 6 x 6 numbers, all with blocks at the same places.
 *
 * Rows of zeros are allowed; their entries in the solution are 0. If other rows are linearly dependent, add a small
 * number to the diagonal, because rounding errors hide the dependence.
 *
 * Usage:
 *
 *     BlockCholesky cholesky(numBlocks, places, isCancelled);
 *     cholesky.setZero();
 *     cholesky.getDiagonal(row) += ...; // and cholesky.addBlock(place, block)
 *     cholesky.factorize();
 *     cholesky.solve(vector);
 *
 * This is a multifrontal method: each supernode of the elimination tree has a dense matrix, a Front, whose rest is
 * added to that of its parent.
 *
 * One thread at a time, which uses all threads that oneTBB gives it. Results do not depend on their number. */
class BlockCholesky
{
public:
    using Block = Eigen::Matrix<double, 6, 6>;

    /** Choose the order of elimination.
     * @param places the row and the column of each block off the diagonal. For two blocks that are each other's
     * transpose, give only one of the two. Several places may be the same.
     * @param isCancelled is called from any thread. */
    BlockCholesky(std::size_t numBlocks, std::span<const std::pair<std::int32_t, std::int32_t>> places,
                  std::function<bool()> isCancelled = {});

    /** Whether the constructor or factorize() was cancelled. Then only the destructor may be called. */
    bool isCancelled() const { return _hasBeenCancelled; }

    void setZero();
    Block& getDiagonal(std::size_t row) { return _diagonal[_tree.getRanks()[row]]; }
    /** Add to the block whose row and column are `places[place]`. */
    void addBlock(std::size_t place, const Block& block) { _blocks[place] += block; }

    void factorize();
    /** Replace the right side of a system of equations by its solution. */
    void solve(Eigen::VectorXd& vector) const;

private:
    using Numbers = std::vector<double, tbb::cache_aligned_allocator<double>>;

    /** A block of the matrix in the front of its supernode. */
    struct Entry
    {
        std::size_t place;
        std::uint32_t row;
        std::uint32_t column;
        bool isTransposed;
    };

    void listEntries(std::span<const std::pair<std::int32_t, std::int32_t>> places);
    void chooseSubtrees();
    /** Ask whether the caller has cancelled. */
    bool mustStop();
    Front getFront(std::size_t index, double* rest) const;
    void factorize(std::size_t index);
    void addEntries(std::size_t index, const Front& front);
    void addRest(std::size_t child, const Front& front);
    /** The rows of a front, which start with the values of its columns; the others are 0. */
    static Numbers startRows(const Front& front, std::span<const double> values);
    void solveForwards(std::size_t index, Eigen::VectorXd& vector, std::vector<Numbers>& shares) const;
    void solveBackwards(std::size_t index, Eigen::VectorXd& vector) const;
    /** Call a function for each supernode, children first, in several threads. */
    template <class Function>
    void forEachUpwards(const Function& function) const;

    std::function<bool()> _isCancelled;
    bool _hasBeenCancelled = false;
    EliminationTree _tree;
    std::vector<Block> _diagonal;             //!< by rank
    std::vector<Block> _blocks;               //!< by place
    std::vector<std::vector<Entry>> _entries; //!< for each supernode
    std::vector<std::size_t> _starts;         //!< for each supernode, the first number of its factor
    mutable Numbers _factor;
    std::vector<double> _reciprocals; //!< of the diagonal of the factor
    std::vector<double> _leastPivots;
    std::vector<Numbers> _rests; //!< of fronts whose parents have not been eliminated
    /** The roots of subtrees that are independent of each other, and all that remain, both in ascending order. */
    std::vector<std::uint32_t> _subtrees, _others;
};

} // namespace osgLego
