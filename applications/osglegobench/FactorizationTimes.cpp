#include "FactorizationTimes.h"

#include <osgLego/stability/BlockCholesky.h>

#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <osg/Timer>

namespace osgLego
{

namespace
{

using Block = BlockCholesky::Block;
using Matrix = Eigen::SparseMatrix<double>;

/** The blocks of the normal matrix A * A^T of a program, and something on the diagonal. */
struct NormalMatrix
{
    std::vector<Block> diagonal;
    std::vector<std::pair<std::int32_t, std::int32_t>> places;
    std::vector<Block> blocks;
};

/** A force and its torque about the centre of a part. */
Wrench moveToCenter(const Wrench& wrench, const Eigen::Vector3d& arm)
{
    Wrench moved = wrench;
    moved.tail<3>() += arm.cross(Eigen::Vector3d(wrench.head<3>()));
    return moved;
}

NormalMatrix createNormalMatrix(const EquilibriumProgram& program)
{
    constexpr double INERTIA = 1e-3;
    NormalMatrix matrix;
    matrix.diagonal.assign(program.getNumBodies(), INERTIA * Block::Identity());
    for (const EquilibriumProgram::Joint& joint : program.getJoints())
    {
        Block mixed = Block::Zero();
        for (std::size_t force = joint.first; force < joint.end; ++force)
        {
            const Wrench upper = moveToCenter(program.getWrench(force), joint.upperArm);
            matrix.diagonal[static_cast<std::size_t>(joint.upper)] += upper * upper.transpose();
            if (joint.lower == EquilibriumProgram::NO_BODY) continue;
            const Wrench lower = moveToCenter(program.getWrench(force), joint.lowerArm);
            matrix.diagonal[static_cast<std::size_t>(joint.lower)] += lower * lower.transpose();
            mixed -= upper * lower.transpose();
        }
        if (joint.lower == EquilibriumProgram::NO_BODY) continue;
        matrix.places.emplace_back(joint.upper, joint.lower);
        matrix.blocks.push_back(mixed);
    }
    return matrix;
}

Matrix createSparseMatrix(const NormalMatrix& matrix)
{
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](Eigen::Index row, Eigen::Index column, const Block& block)
    {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                entries.emplace_back(6 * row + i, 6 * column + j, block(i, j));
    };
    for (std::size_t body = 0; body < matrix.diagonal.size(); ++body)
        add(static_cast<Eigen::Index>(body), static_cast<Eigen::Index>(body), matrix.diagonal[body]);
    for (std::size_t place = 0; place < matrix.places.size(); ++place)
    {
        const auto& [row, column] = matrix.places[place];
        add(row, column, matrix.blocks[place]);
        add(column, row, matrix.blocks[place].transpose());
    }
    const auto size = static_cast<Eigen::Index>(6 * matrix.diagonal.size());
    Matrix sparse(size, size);
    sparse.setFromTriplets(entries.begin(), entries.end());
    return sparse;
}

} // namespace

FactorizationTimes measureFactorizations(const EquilibriumProgram& program, unsigned int numRuns)
{
    const NormalMatrix matrix = createNormalMatrix(program);
    const Matrix sparse = createSparseMatrix(matrix);
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(sparse.rows(), -1.0, 1.0);
    BlockCholesky blocks(matrix.diagonal.size(), matrix.places);
    Eigen::SimplicialLLT<Matrix> simplicial;
    simplicial.analyzePattern(sparse);
    FactorizationTimes times;
    const osg::Timer& timer = *osg::Timer::instance();
    for (unsigned int run = 0; run < numRuns; ++run)
    {
        blocks.setZero();
        for (std::size_t body = 0; body < matrix.diagonal.size(); ++body)
            blocks.getDiagonal(body) = matrix.diagonal[body];
        for (std::size_t place = 0; place < matrix.places.size(); ++place)
            blocks.addBlock(place, matrix.blocks[place]);
        const osg::Timer_t start = timer.tick();
        blocks.factorize();
        const osg::Timer_t middle = timer.tick();
        simplicial.factorize(sparse);
        times.blocks.push_back(timer.delta_m(start, middle));
        times.simplicial.push_back(timer.delta_m(middle, timer.tick()));
    }
    Eigen::VectorXd solution = right;
    blocks.solve(solution);
    if ((sparse * solution - right).norm() > 1e-6 * right.norm() ||
        (solution - simplicial.solve(right)).norm() > 1e-6 * solution.norm())
        throw std::runtime_error("two factorizations of the same matrix give different solutions");
    return times;
}

} // namespace osgLego
