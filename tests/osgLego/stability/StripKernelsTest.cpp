#include <osgLego/stability/StripKernels.h>

#include <cstddef>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr auto ROWS = static_cast<Eigen::Index>(StripKernels::NUM_ROWS);

Eigen::MatrixXd createStrip(Eigen::Index numColumns)
{
    return Eigen::MatrixXd::Random(ROWS, numColumns);
}

/** A lower triangular matrix. */
Eigen::MatrixXd createTriangle(Eigen::Index size)
{
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Random(size, size).triangularView<Eigen::Lower>();
    triangle.diagonal().array() = triangle.diagonal().array().abs() + 1.0;
    return triangle;
}

TEST(StripKernels, SubtractProductsOnEveryKindOfProcessor)
{
    for (const StripKernels& kernels : StripKernels::getAll())
        for (const Eigen::Index count : {0, 1, 6, 24, 250})
        {
            const Eigen::MatrixXd left = createStrip(count);
            const Eigen::MatrixXd right = createStrip(count);
            const Eigen::MatrixXd start = createStrip(ROWS);
            Eigen::MatrixXd result = start;
            kernels.subtractProduct(left.data(), right.data(), static_cast<std::size_t>(count), result.data());
            EXPECT_LT((result - (start - left * right.transpose())).norm(), 1e-11) << count;

            const Eigen::VectorXd vector = Eigen::VectorXd::Random(count);
            Eigen::VectorXd column = start.col(0);
            kernels.subtractVector(left.data(), static_cast<std::size_t>(count), vector.data(), column.data());
            EXPECT_LT((column - (start.col(0) - left * vector)).norm(), 1e-11) << count;

            Eigen::VectorXd row = vector;
            kernels.subtractTransposed(left.data(), static_cast<std::size_t>(count), start.data(), row.data());
            EXPECT_LT((row - (vector - left.transpose() * start.col(0))).norm(), 1e-11) << count;
        }
}

TEST(StripKernels, DivideByTrianglesOnEveryKindOfProcessor)
{
    for (const StripKernels& kernels : StripKernels::getAll())
        for (const Eigen::Index count : {6, 12, 18, 24})
        {
            const Eigen::MatrixXd triangle = createTriangle(count);
            Eigen::MatrixXd padded = createStrip(count);
            padded.topRows(count) = triangle;
            const Eigen::VectorXd reciprocals = triangle.diagonal().cwiseInverse();
            const Eigen::MatrixXd quotient = createStrip(count);
            Eigen::MatrixXd strip = quotient * triangle.transpose();
            kernels.divide(padded.data(), reciprocals.data(), static_cast<std::size_t>(count), strip.data());
            EXPECT_LT((strip - quotient).norm(), 1e-11) << count;
        }
}

TEST(StripKernels, FactorizeOnEveryKindOfProcessor)
{
    for (const StripKernels& kernels : StripKernels::getAll())
        for (const Eigen::Index count : {6, 12, 18, 24})
        {
            Eigen::MatrixXd expected = createStrip(count);
            const Eigen::MatrixXd triangle = createTriangle(count);
            expected.topRows(count) = triangle;
            Eigen::MatrixXd strip = expected * triangle.transpose();
            const Eigen::VectorXd leastPivots = Eigen::VectorXd::Zero(count);
            Eigen::VectorXd reciprocals(count);
            kernels.factorize(strip.data(), static_cast<std::size_t>(count), leastPivots.data(), reciprocals.data());
            EXPECT_LT((strip - expected).norm(), 1e-10) << count;
            EXPECT_LT((reciprocals - triangle.diagonal().cwiseInverse()).norm(), 1e-11) << count;
        }
}

TEST(StripKernels, ReplaceSmallPivots)
{
    for (const StripKernels& kernels : StripKernels::getAll())
    {
        Eigen::MatrixXd strip = Eigen::MatrixXd::Zero(ROWS, 6);
        strip.topRows(6).diagonal() << 4.0, -1e-9, 0.0, 1e-9, 9.0, 1.0;
        Eigen::VectorXd leastPivots = Eigen::VectorXd::Constant(6, 0.25);
        leastPivots[2] = 0.0;
        Eigen::VectorXd reciprocals(6);
        kernels.factorize(strip.data(), 6, leastPivots.data(), reciprocals.data());
        EXPECT_EQ(reciprocals[0], 0.5);
        EXPECT_EQ(reciprocals[1], 2.0);
        EXPECT_LT(reciprocals[2], 1e-40);
        EXPECT_EQ(reciprocals[3], 2.0);
    }
}

} // namespace

} // namespace osgLego::test
