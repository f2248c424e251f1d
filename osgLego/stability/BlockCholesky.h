#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

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
 * Eigen's SimplicialLLT works on single numbers instead of blocks and takes 4.5 times as long: 552 ms instead of 123 ms
 * for the 5,587 parts of the bunny at 86 (`osglegobench stability` prints both), and CHOLMOD's simplicial factorization
 * 6 times.
 *
 * One thread at a time. */
class BlockCholesky
{
public:
    using Block = Eigen::Matrix<double, 6, 6>;

    /** Choose the order of elimination.
     * @param places the row and the column of each block off the diagonal. For two blocks that are each other's
     * transpose, give only one of the two. Several places may be the same. */
    BlockCholesky(std::size_t numBlocks, std::span<const std::pair<std::int32_t, std::int32_t>> places,
                  std::function<bool()> isCancelled = {});

    /** Whether the constructor or factorize() was cancelled. Then only the destructor may be called. */
    bool isCancelled() const { return _hasBeenCancelled; }

    void setZero();
    Block& getDiagonal(std::size_t row) { return _diagonal[_ranks[row]]; }
    /** Add to the block whose row and column are `places[place]`. */
    void addBlock(std::size_t place, const Block& block);

    void factorize();
    /** Replace the right side of a system of equations by its solution. */
    void solve(Eigen::VectorXd& vector) const;

private:
    void analyze(std::size_t numBlocks, std::span<const std::pair<std::int32_t, std::int32_t>> places);

    /** Ask whether the caller has cancelled. */
    bool mustStop();

    std::function<bool()> _isCancelled;
    bool _hasBeenCancelled = false;
    std::vector<std::uint32_t> _ranks; //!< for each row of the matrix, its rank in the order of elimination
    std::vector<Block> _diagonal;
    std::vector<std::size_t> _starts;    //!< for each column, its first block in _rows and _blocks
    std::vector<std::uint32_t> _rows;    //!< ascending in each column
    std::vector<Block> _blocks;          //!< of the lower triangle
    std::vector<std::size_t> _targets;   //!< for each place, its block
    std::vector<bool> _isTransposed;     //!< for each place, whether its block is transposed
    std::vector<std::size_t> _rowStarts; //!< for each row, its first entry in _rowBlocks
    /** The blocks in a row: their columns and indices. */
    std::vector<std::pair<std::uint32_t, std::size_t>> _rowBlocks;
    std::vector<std::size_t> _scatter;
};

} // namespace osgLego
