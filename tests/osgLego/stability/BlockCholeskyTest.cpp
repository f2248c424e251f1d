#include <osgLego/stability/BlockCholesky.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace osgLego::test
{

namespace
{

using Places = std::vector<std::pair<std::int32_t, std::int32_t>>;

/** A random symmetric positive semidefinite matrix of blocks: the sum of products B * B^T of blocks B of rows at two
 * places, as forces between two parts make it. */
class RandomMatrix
{
public:
    /** @param rank of the contribution of each pair of places, up to 12. */
    RandomMatrix(unsigned int seed, std::int32_t numBlocks, int density, Eigen::Index rank) :
        _random(seed), _dense(Eigen::MatrixXd::Zero(6 * numBlocks, 6 * numBlocks)), _numBlocks(numBlocks)
    {
        for (std::int32_t row = 0; row < numBlocks; ++row)
            for (std::int32_t column = 0; column < row; ++column)
                if (static_cast<int>(_random() % 100) < density)
                {
                    // Both triangles.
                    _places.push_back(_random() % 2 == 0 ? std::pair(row, column) : std::pair(column, row));
                    add(row, column, rank);
                }
    }

    /** Add the same number to each entry of the diagonal, so that the matrix becomes definite. */
    void shift(double value) { _dense.diagonal().array() += value; }
    void clear(Eigen::Index row)
    {
        _dense.row(row).setZero();
        _dense.col(row).setZero();
    }

    const Eigen::MatrixXd& getDense() const { return _dense; }

    Eigen::VectorXd createVector()
    {
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        return Eigen::VectorXd::NullaryExpr(_dense.rows(), [&] { return number(_random); });
    }

    BlockCholesky createCholesky() const
    {
        BlockCholesky cholesky(static_cast<std::size_t>(_numBlocks), _places);
        // Twice, since one object factorizes many matrices.
        for (int round = 0; round < 2; ++round)
        {
            cholesky.setZero();
            for (std::int32_t block = 0; block < _numBlocks; ++block)
                cholesky.getDiagonal(static_cast<std::size_t>(block)) += _dense.block<6, 6>(6 * block, 6 * block);
            for (std::size_t place = 0; place < _places.size(); ++place)
                cholesky.addBlock(place, _dense.block<6, 6>(6 * _places[place].first, 6 * _places[place].second));
            cholesky.factorize();
        }
        return cholesky;
    }

private:
    void add(std::int32_t row, std::int32_t column, Eigen::Index rank)
    {
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        const Eigen::MatrixXd factor = Eigen::MatrixXd::NullaryExpr(12, rank, [&] { return number(_random); });
        const Eigen::MatrixXd product = factor * factor.transpose();
        const Eigen::Index a = 6 * row;
        const Eigen::Index b = 6 * column;
        _dense.block<6, 6>(a, a) += product.topLeftCorner<6, 6>();
        _dense.block<6, 6>(a, b) += product.topRightCorner<6, 6>();
        _dense.block<6, 6>(b, a) += product.bottomLeftCorner<6, 6>();
        _dense.block<6, 6>(b, b) += product.bottomRightCorner<6, 6>();
    }

    std::mt19937 _random;
    Places _places;
    Eigen::MatrixXd _dense;
    std::int32_t _numBlocks;
};

TEST(BlockCholesky, SolvesDefiniteSystemsAsEigenDoes)
{
    for (unsigned int seed = 1; seed <= 20; ++seed)
        for (const int density : {0, 5, 20, 100})
        {
            RandomMatrix matrix(seed, 1 + static_cast<std::int32_t>(seed), density, 8);
            matrix.shift(0.5);
            const Eigen::VectorXd right = matrix.createVector();
            const Eigen::VectorXd expected = matrix.getDense().llt().solve(right);
            Eigen::VectorXd solution = right;
            matrix.createCholesky().solve(solution);
            EXPECT_LT((solution - expected).norm(), 1e-11 * expected.norm()) << seed << ", " << density;
        }
}

TEST(BlockCholesky, SolvesSemidefiniteSystemsWithALittleOnTheDiagonalAsEigenDoes)
{
    // As the interior-point solver has them: without the little term, most of these matrices have no inverse.
    constexpr double INERTIA = 1e-7;
    for (unsigned int seed = 1; seed <= 20; ++seed)
        for (const Eigen::Index rank : {1, 2, 5})
        {
            RandomMatrix matrix(seed, 15, 10, rank);
            const Eigen::VectorXd right = matrix.getDense() * matrix.createVector();
            matrix.shift(INERTIA);
            const Eigen::VectorXd expected = matrix.getDense().ldlt().solve(right);
            Eigen::VectorXd solution = right;
            matrix.createCholesky().solve(solution);
            // The condition number of 1e8 is lost.
            EXPECT_LT((solution - expected).norm(), 1e-6 * expected.norm()) << seed << ", " << rank;
            EXPECT_LT((matrix.getDense() * solution - right).norm(), 1e-12 * right.norm()) << seed << ", " << rank;
        }
}

/** A grid of blocks that are connected to their neighbours, as the parts of a solid are. */
class GridMatrix
{
public:
    explicit GridMatrix(std::int32_t length) : _numBlocks(static_cast<std::size_t>(length * length * length))
    {
        for (std::int32_t block = 0; block < length * length * length; ++block)
            for (const std::int32_t step : {1, length, length * length})
                if (block / step % length + 1 < length) _places.emplace_back(block, block + step);
    }

    const Places& getPlaces() const { return _places; }
    std::size_t getNumBlocks() const { return _numBlocks; }

    Eigen::VectorXd solve(BlockCholesky& cholesky) const
    {
        cholesky.setZero();
        for (std::size_t place = 0; place < _places.size(); ++place)
        {
            const BlockCholesky::Block block = createBlock(place);
            cholesky.getDiagonal(static_cast<std::size_t>(_places[place].first)) += block;
            cholesky.getDiagonal(static_cast<std::size_t>(_places[place].second)) += block;
            cholesky.addBlock(place, -block);
        }
        for (std::size_t block = 0; block < _numBlocks; ++block)
            cholesky.getDiagonal(block) += SHIFT * BlockCholesky::Block::Identity();
        cholesky.factorize();
        Eigen::VectorXd vector = createRight();
        if (!cholesky.isCancelled()) cholesky.solve(vector);
        return vector;
    }

    Eigen::VectorXd createRight() const
    {
        return Eigen::VectorXd::LinSpaced(6 * static_cast<Eigen::Index>(_numBlocks), -1.0, 1.0);
    }

    Eigen::VectorXd multiply(const Eigen::VectorXd& vector) const
    {
        Eigen::VectorXd product = SHIFT * vector;
        for (std::size_t place = 0; place < _places.size(); ++place)
        {
            const Eigen::Index row = 6 * _places[place].first;
            const Eigen::Index column = 6 * _places[place].second;
            const Eigen::Matrix<double, 6, 1> share =
                createBlock(place) * (vector.segment<6>(row) - vector.segment<6>(column));
            product.segment<6>(row) += share;
            product.segment<6>(column) -= share;
        }
        return product;
    }

private:
    static constexpr double SHIFT = 0.1;

    static BlockCholesky::Block createBlock(std::size_t place)
    {
        const auto number = static_cast<double>(place % 7);
        const Eigen::Matrix<double, 6, 1> values = Eigen::Matrix<double, 6, 1>::LinSpaced(number - 3.0, number);
        return values * values.transpose() + 0.5 * BlockCholesky::Block::Identity();
    }

    std::size_t _numBlocks;
    Places _places;
};

TEST(BlockCholesky, SolvesGrids)
{
    for (const std::int32_t length : {2, 5, 9})
    {
        const GridMatrix matrix(length);
        BlockCholesky cholesky(matrix.getNumBlocks(), matrix.getPlaces());
        const Eigen::VectorXd solution = matrix.solve(cholesky);
        EXPECT_LT((matrix.multiply(solution) - matrix.createRight()).norm(), 1e-11 * solution.norm()) << length;
    }
}

TEST(BlockCholesky, SolutionsDoNotDependOnTheNumberOfThreads)
{
    const GridMatrix matrix(11);
    std::vector<Eigen::VectorXd> solutions;
    for (const std::size_t numThreads : {1u, 2u, 7u, 7u})
    {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, numThreads);
        tbb::task_arena arena(static_cast<int>(numThreads));
        arena.execute(
            [&]
            {
                BlockCholesky cholesky(matrix.getNumBlocks(), matrix.getPlaces());
                solutions.push_back(matrix.solve(cholesky));
            });
    }
    for (const Eigen::VectorXd& solution : solutions)
        EXPECT_EQ(solution, solutions.front());
}

TEST(BlockCholesky, SolutionsAreCompleteEvenIfTheTaskThatComputesThemIsCancelled)
{
    const GridMatrix matrix(11);
    BlockCholesky cholesky(matrix.getNumBlocks(), matrix.getPlaces());
    const Eigen::VectorXd expected = matrix.solve(cholesky);
    Eigen::VectorXd solution;
    tbb::task_group group;
    group.run_and_wait(
        [&]
        {
            group.cancel();
            solution = matrix.solve(cholesky);
        });
    EXPECT_EQ(solution, expected);
}

TEST(BlockCholesky, CanBeCancelledWithinADenseMatrix)
{
    constexpr std::int32_t NUM_BLOCKS = 60;
    Places places;
    for (std::int32_t row = 0; row < NUM_BLOCKS; ++row)
        for (std::int32_t column = 0; column < row; ++column)
            places.emplace_back(row, column);
    std::atomic<int> numCalls = 0;
    BlockCholesky cholesky(NUM_BLOCKS, places, [&] { return ++numCalls < 0; });
    cholesky.setZero();
    numCalls = 0;
    cholesky.factorize();
    // For each 24 of 360 columns.
    EXPECT_GE(numCalls, 15);
    int calls = 0;
    BlockCholesky cancelled(NUM_BLOCKS, places, [&] { return ++calls == NUM_BLOCKS + 8; });
    cancelled.factorize();
    EXPECT_TRUE(cancelled.isCancelled());
    EXPECT_EQ(calls, NUM_BLOCKS + 8);
}

TEST(BlockCholesky, RowsOfZerosGetNothing)
{
    for (unsigned int seed = 1; seed <= 10; ++seed)
    {
        RandomMatrix matrix(seed, 8, 40, 8);
        matrix.shift(0.5);
        for (const Eigen::Index row : {3, 20, 21, 47})
            matrix.clear(row);
        const Eigen::VectorXd right = matrix.getDense() * matrix.createVector();
        Eigen::VectorXd solution = right;
        for (const Eigen::Index row : {3, 20, 21, 47})
            solution[row] = 1.0;
        matrix.createCholesky().solve(solution);
        EXPECT_LT((matrix.getDense() * solution - right).norm(), 1e-12 * right.norm()) << seed;
        for (const Eigen::Index row : {3, 20, 21, 47})
            EXPECT_NEAR(solution[row], 0.0, 1e-30) << seed << ", " << row;
    }
}

} // namespace

} // namespace osgLego::test
