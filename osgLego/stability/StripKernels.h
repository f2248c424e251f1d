#pragma once

#include <cstddef>
#include <vector>

namespace osgLego
{

/** Products of dense matrices in strips of 24 rows: arrays of columns of 24 numbers, one after the other.
 *
 * 24 rows are four blocks of 6, and fill the registers of every kind of processor. There is a set of functions for each
 * kind; rounding errors differ between them. Every function may be called from any thread. */
struct StripKernels
{
    static constexpr std::size_t NUM_ROWS = 24;

    /** Subtract left * transposed right from a matrix of 24 x 24 numbers.
     * left and right are strips of the same number of columns, null if there are none, and the result is a strip of 24
     * columns. */
    void (*subtractProduct)(const double* left, const double* right, std::size_t numColumns, double* result);

    /** Replace the first rows of a strip, a symmetric matrix of which the lower triangle counts, by their Cholesky
     * factor L, and divide the other rows by the transpose of L, from the right. The upper triangle becomes 0.
     * Pivots less than those in leastPivots are replaced by these; where they are 0 too, the column becomes 0.
     * reciprocals become those of the diagonal. */
    void (*factorize)(double* strip, std::size_t numColumns, const double* leastPivots, double* reciprocals);

    /** Divide a strip by the transpose of a lower triangular matrix, from the right. Of the strip `triangle`, only the
     * lower triangle below the diagonal counts; reciprocals has those of the diagonal. */
    void (*divide)(const double* triangle, const double* reciprocals, std::size_t numColumns, double* strip);

    /** Subtract strip * vector from 24 numbers. */
    void (*subtractVector)(const double* strip, std::size_t numColumns, const double* vector, double* result);

    /** Subtract transposed strip * vector of 24 numbers from numColumns numbers. */
    void (*subtractTransposed)(const double* strip, std::size_t numColumns, const double* vector, double* result);

    /** The fastest functions for this processor. */
    static const StripKernels& get();
    /** All that this processor can execute, the fastest first. */
    static std::vector<StripKernels> getAll();
};

} // namespace osgLego
