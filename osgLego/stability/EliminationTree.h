#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace osgLego
{

/** The order in which BlockCholesky eliminates the rows of a symmetric matrix, and the shape of the factor.
 *
 * Columns whose factors have nearly the same rows are adjacent and form a supernode. The rows of a supernode below its
 * own columns are columns or rows of its parent.
 *
 * Immutable once created; every function may be called from any thread. */
class EliminationTree
{
public:
    static constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

    /** Adjacent columns that are eliminated together; ranks instead of numbers of rows. */
    struct Supernode
    {
        std::uint32_t first = 0; //!< column
        std::uint32_t numColumns = 0;
        std::vector<std::uint32_t> rows;    //!< those below the columns, ascending
        std::uint32_t parent = NONE;        //!< a later supernode
        std::vector<std::uint32_t> targets; //!< for each of `rows`, its place among columns and rows of the parent
        std::vector<std::uint32_t> children;
        double work = 0.0; //!< multiplications of blocks, here and in all descendants
        std::uint32_t firstDescendant = 0;

        std::size_t getNumRows() const { return numColumns + rows.size(); }
    };

    /** @param places the row and the column of each block off the diagonal, of which one triangle is enough.
     * @param isCancelled ends the constructor early by returning true; may be empty. Then only the destructor may be
     * called. */
    EliminationTree(std::size_t numBlocks, std::span<const std::pair<std::int32_t, std::int32_t>> places,
                    const std::function<bool()>& isCancelled);

    /** For each row of the matrix, its rank in the order of elimination. */
    const std::vector<std::uint32_t>& getRanks() const { return _ranks; }
    /** In the order of elimination: descendants are before their ancestors, and adjacent. */
    const std::vector<Supernode>& getSupernodes() const { return _supernodes; }
    /** The supernode of a rank. */
    std::uint32_t findSupernode(std::uint32_t rank) const { return _supernodeOfRank[rank]; }
    /** The place of a rank among the columns and rows of a supernode. */
    std::uint32_t findTarget(std::uint32_t supernode, std::uint32_t rank) const;

private:
    using Columns = std::vector<std::vector<std::uint32_t>>;

    void sortChildrenFirst(Columns& columns);
    void joinColumns(Columns& columns);
    void connect();

    std::vector<std::uint32_t> _ranks;
    std::vector<Supernode> _supernodes;
    std::vector<std::uint32_t> _supernodeOfRank;
};

} // namespace osgLego
