#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace osgLego
{

/** The ways to fill the columns of one sheet with blocks, from top to bottom and then from left to right.
 *
 *     const SheetFilling filling(blocks, 2, 176.5);
 *     for (const std::size_t end : filling.findEnds(5)) ... // of the columns, with the first five blocks
 *
 * Immutable. Uses no GL. */
class SheetFilling
{
public:
    static constexpr double IMPOSSIBLE = 1e18;

    /** A block with the space below it. */
    struct Block
    {
        double height = 0.0;
        /** The cost of ending a column behind it, unless that is the last column: the square of a free share. */
        double endCost = 0.0;
    };

    /** @param numColumns each of which gets a block.
     * @param capacity the height of a column, with the space below its last block. */
    SheetFilling(std::span<const Block> blocks, std::size_t numColumns, double capacity);

    /** The largest number of blocks that fit. */
    std::size_t getMostBlocks() const { return _costs.back().size() - 1; }
    /** The mean square of the free share of each column, with the cost of its end, or IMPOSSIBLE. @param numBlocks up
     * to getMostBlocks(). */
    double getCost(std::size_t numBlocks) const;
    /** The number of blocks up to the end of each column, for the lowest cost. */
    std::vector<std::size_t> findEnds(std::size_t numBlocks) const;

private:
    // For each number of columns, and of blocks in them: the sum of squares, and the first block of the last column.
    std::vector<std::vector<double>> _costs;
    std::vector<std::vector<std::size_t>> _firsts;
};

} // namespace osgLego
