#include <osgLego/stability/RowEquations.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace osgLego
{

namespace
{

constexpr int MOST_REFINEMENTS = 10;
constexpr double SOLUTION_TOLERANCE = 1e-8; // relative to the right side

using Places = std::vector<std::pair<std::int32_t, std::int32_t>>;

/** The parts of the contacts between two parts. */
Places findPlaces(const EquilibriumProgram& program)
{
    Places places;
    for (const EquilibriumProgram::Joint& joint : program.getJoints())
        if (joint.lower != EquilibriumProgram::NO_BODY) places.emplace_back(joint.upper, joint.lower);
    return places;
}

/** The matrix that moves the place about which wrenches are to the origin of `arm`. */
BlockCholesky::Block createShift(const Eigen::Vector3d& arm)
{
    BlockCholesky::Block shift = BlockCholesky::Block::Identity();
    shift(3, 1) = -arm.z();
    shift(3, 2) = arm.y();
    shift(4, 0) = arm.z();
    shift(4, 2) = -arm.x();
    shift(5, 0) = -arm.y();
    shift(5, 1) = arm.x();
    return shift;
}

} // namespace

double RowEquations::countProducts(const EquilibriumProgram& program, const std::function<bool()>& isCancelled)
{
    const EliminationTree tree(program.getNumBodies(), findPlaces(program), isCancelled);
    if (isCancelled && isCancelled()) return 0.0;
    double count = 0.0;
    for (const EliminationTree::Supernode& supernode : tree.getSupernodes())
        if (supernode.parent == EliminationTree::NONE) count += supernode.work;
    return count;
}

RowEquations::RowEquations(const EquilibriumProgram& program, const std::function<bool()>& isCancelled) :
    _program(program), _cholesky(program.getNumBodies(), findPlaces(program), isCancelled)
{
}

void RowEquations::factorize(const Eigen::ArrayXd& weights, const Eigen::ArrayXd& rowWeights)
{
    _weights = weights;
    _rowWeights = rowWeights;
    _cholesky.setZero();
    for (std::size_t body = 0; body < _program.getNumBodies(); ++body)
        _cholesky.getDiagonal(body).diagonal() = rowWeights.segment<6>(6 * static_cast<Eigen::Index>(body));
    std::size_t place = 0;
    for (const EquilibriumProgram::Joint& joint : _program.getJoints())
    {
        BlockCholesky::Block sum = BlockCholesky::Block::Zero();
        for (std::size_t force = joint.first; force < joint.end; ++force)
        {
            const Wrench& wrench = _program.getWrench(force);
            sum.noalias() += (weights[static_cast<Eigen::Index>(force)] * wrench) * wrench.transpose();
        }
        const BlockCholesky::Block upper = createShift(joint.upperArm);
        const BlockCholesky::Block shifted = upper * sum;
        _cholesky.getDiagonal(static_cast<std::size_t>(joint.upper)) += shifted * upper.transpose();
        if (joint.lower == EquilibriumProgram::NO_BODY) continue;
        const BlockCholesky::Block lower = createShift(joint.lowerArm);
        _cholesky.getDiagonal(static_cast<std::size_t>(joint.lower)) += lower * sum * lower.transpose();
        _cholesky.addBlock(place++, -shifted * lower.transpose());
    }
    _cholesky.factorize();
}

void RowEquations::multiply(const Eigen::VectorXd& vector, Eigen::VectorXd& product) const
{
    Eigen::VectorXd forces;
    _program.multiplyTransposed(vector, forces);
    forces.array() *= _weights;
    _program.multiply(forces, product);
    product.array() += _rowWeights * vector.array();
}

void RowEquations::solve(Eigen::VectorXd& rows) const
{
    const double tolerance = SOLUTION_TOLERANCE * rows.norm();
    Eigen::VectorXd solution = rows;
    _cholesky.solve(solution);
    Eigen::VectorXd product;
    multiply(solution, product);
    Eigen::VectorXd error = rows - product;
    double least = error.norm();
    rows = solution;
    Eigen::VectorXd direction;
    double previous = 0.0;
    for (int round = 0; round < MOST_REFINEMENTS && error.norm() > tolerance; ++round)
    {
        Eigen::VectorXd change = error;
        _cholesky.solve(change);
        const double weight = error.dot(change);
        if (round > 0) change += (weight / previous) * direction;
        direction = std::move(change);
        previous = weight;
        multiply(direction, product);
        const double curvature = direction.dot(product);
        if (!(curvature > 0.0)) return;
        solution += (weight / curvature) * direction;
        error -= (weight / curvature) * product;
        if (!(error.norm() < least)) continue;
        least = error.norm();
        rows = solution;
    }
}

} // namespace osgLego
