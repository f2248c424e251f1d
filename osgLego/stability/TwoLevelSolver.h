#pragma once

#include <functional>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace osgLego
{

/** Solves sparse symmetric positive definite equations of bodies that springs connect, by conjugate gradients.
 *
 * The preconditioner has two levels: an incomplete Cholesky factorization for movements of neighbours against each
 * other, and the exact solution for movements of groups of bodies as a whole, which the first would need very many
 * steps for (an additive Schwarz method with a coarse space).
 *
 * Usage:
 *
 *     TwoLevelSolver solver(movements);
 *     if (solver.factorize(matrix, isCancelled) && solver.solve(rightSide, 1e-9, isCancelled, solution)) ...
 *
 * One thread at a time. */
class TwoLevelSolver
{
public:
    using Matrix = Eigen::SparseMatrix<double>;

    /** @param movements a column for each movement of a group, linearly independent of each other. */
    explicit TwoLevelSolver(const Matrix& movements) : _movements(movements) {}

    /** @param matrix with both triangles.
     * @param isCancelled is called between steps; may be empty.
     * @return whether it is positive definite, as far as that shows; false if it was cancelled. */
    bool factorize(const Matrix& matrix, const std::function<bool()>& isCancelled);

    /** @param tolerance of the residual, relative to the right side.
     * @param isCancelled is called in each step; may be empty.
     * @param solution from which the search starts.
     * @return whether the tolerance was reached. */
    bool solve(const Eigen::VectorXd& rightSide, double tolerance, const std::function<bool()>& isCancelled,
               Eigen::VectorXd& solution) const;

private:
    Eigen::VectorXd precondition(const Eigen::VectorXd& residual) const;

    Matrix _movements;
    Matrix _matrix;
    Eigen::IncompleteCholesky<double> _near;
    Eigen::SimplicialLLT<Matrix> _far;
};

} // namespace osgLego
