#pragma once

#include <cstddef>
#include <functional>

namespace osgLego
{

/** A dense symmetric matrix of which the first columns are eliminated, in two arrays of strips (see StripKernels).
 *
 * The factor has the columns that are eliminated, for each strip of rows: those up to the diagonal. The rest, to which
 * the products of these columns are added, has tiles of 24 x 24 numbers of the lower triangle.
 *
 * Usage:
 *
 *     Front front(numColumns, numRows, factor, rest);
 *     // add to the numbers at front.findBlock(row, column)
 *     front.factorize(leastPivots, reciprocals, mustStop);
 *
 * Results do not depend on the number of threads. */
class Front
{
public:
    /** @param numColumns of numbers that are eliminated, and @param numRows of all, multiples of 6.
     * @param factor an array of getFactorSize() numbers, and @param rest one of getRestSize(), which the caller
     * owns. */
    Front(std::size_t numColumns, std::size_t numRows, double* factor, double* rest);

    static std::size_t getFactorSize(std::size_t numColumns, std::size_t numRows);
    static std::size_t getRestSize(std::size_t numColumns, std::size_t numRows);

    /** The first number of a block of 6 x 6. Each of its columns is 24 numbers after the previous one. Within a block
     * on the diagonal, both triangles count. @param row,column the numbers of the block, row >= column. */
    double* findBlock(std::size_t row, std::size_t column) const;

    /** @param leastPivots for each column, the value that replaces smaller pivots.
     * @param reciprocals become those of the diagonal of the factor.
     * @param mustStop ends the function early by returning true; called from any thread.
     * @return false if it was ended. */
    bool factorize(const double* leastPivots, double* reciprocals, const std::function<bool()>& mustStop) const;

    /** Solve the equations of the eliminated columns with the factor, and subtract their share from the other rows.
     * @param rows an array of getNumStrips() * 24 numbers. */
    void solveForwards(const double* reciprocals, double* rows) const;
    /** Solve the transposed equations of the eliminated columns, where the other rows are known. */
    void solveBackwards(const double* reciprocals, double* rows) const;

    std::size_t getNumStrips() const { return _numStrips; }

private:
    double* getStrip(std::size_t strip) const;
    double* getTile(std::size_t row, std::size_t column) const;
    void factorizePanel(std::size_t panel, const double* leastPivots, double* reciprocals) const;

    std::size_t _numColumns;
    std::size_t _numStrips;
    double* _factor;
    double* _rest;
};

} // namespace osgLego
