#include <osgLego/stability/TwoLevelSolver.h>

namespace osgLego
{

bool TwoLevelSolver::factorize(const Matrix& matrix, const std::function<bool()>& isCancelled)
{
    const auto mustStop = [&isCancelled] { return isCancelled && isCancelled(); };
    _matrix = matrix;
    if (mustStop()) return false;
    _near.compute(_matrix);
    if (mustStop()) return false;
    const Matrix moved = _matrix * _movements;
    _far.compute(_movements.transpose() * moved);
    return _near.info() == Eigen::Success && _far.info() == Eigen::Success;
}

bool TwoLevelSolver::solve(const Eigen::VectorXd& rightSide, double tolerance, const std::function<bool()>& isCancelled,
                           Eigen::VectorXd& solution) const
{
    constexpr int MOST_STEPS = 1000;
    const double least = tolerance * rightSide.norm();
    Eigen::VectorXd residual = rightSide - _matrix * solution;
    Eigen::VectorXd direction = precondition(residual);
    double product = residual.dot(direction);
    for (int step = 0; step < MOST_STEPS; ++step)
    {
        if (residual.norm() <= least) return true;
        if (isCancelled && isCancelled()) return false;
        const Eigen::VectorXd change = _matrix * direction;
        const double curvature = direction.dot(change);
        if (!(curvature > 0.0)) return false; // written so that NaN ends it, too
        const double length = product / curvature;
        solution += length * direction;
        residual -= length * change;
        const Eigen::VectorXd preconditioned = precondition(residual);
        const double next = residual.dot(preconditioned);
        direction = preconditioned + (next / product) * direction;
        product = next;
    }
    return false;
}

Eigen::VectorXd TwoLevelSolver::precondition(const Eigen::VectorXd& residual) const
{
    const Eigen::VectorXd far = _far.solve(_movements.transpose() * residual);
    return _near.solve(residual) + _movements * far;
}

} // namespace osgLego
