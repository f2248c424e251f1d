#pragma once

#include <osgLego/stability/BlockCholesky.h>
#include <osgLego/stability/EquilibriumProgram.h>

#include <functional>

#include <Eigen/Core>

namespace osgLego
{

/** The normal equations of an EquilibriumProgram: (columns * weights * transposed columns + row weights) * solution =
 * right side. They have a block of 6 x 6 numbers for each part and for each contact.
 *
 * Usage:
 *
 *     RowEquations equations(program, isCancelled);
 *     equations.factorize(weights, rowWeights);
 *     if (!equations.isCancelled()) equations.solve(rows);
 *
 * One thread at a time. */
class RowEquations
{
public:
    /** The number of multiplications of blocks in a factorization, which tells how long it takes.
     * @param isCancelled may be empty; once it returns true, the number is 0. */
    static double countProducts(const EquilibriumProgram& program, const std::function<bool()>& isCancelled);

    /** @param program must outlive this object. @param isCancelled may be empty. */
    RowEquations(const EquilibriumProgram& program, const std::function<bool()>& isCancelled);

    /** Whether the constructor or factorize() was cancelled. Then only the destructor may be called. */
    bool isCancelled() const { return _cholesky.isCancelled(); }

    /** @param weights of the forces. @param rowWeights of the rows. */
    void factorize(const Eigen::ArrayXd& weights, const Eigen::ArrayXd& rowWeights);
    /** Replace the right side by the solution. Weights may differ by a factor of 1e20, so that the factorization alone
     * is imprecise; it is the preconditioner of conjugate gradients. */
    void solve(Eigen::VectorXd& rows) const;

private:
    void multiply(const Eigen::VectorXd& vector, Eigen::VectorXd& product) const;

    const EquilibriumProgram& _program;
    BlockCholesky _cholesky;
    Eigen::ArrayXd _weights;
    Eigen::ArrayXd _rowWeights;
};

} // namespace osgLego
