#include <osgLego/stability/LeastPull.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <Clp_C_Interface.h>
#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Points = std::vector<Eigen::Vector2d>;

/** The same by a linear program: the least t so that forces of at least -t have the sum of the load. */
double solveByClp(const Eigen::Vector3d& load, const Points& points)
{
    std::vector<CoinBigIndex> starts{0};
    std::vector<int> rows;
    std::vector<double> values;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const auto addColumn = [&](const Eigen::Vector3d& column)
    {
        for (int row = 0; row < 3; ++row)
        {
            rows.push_back(row);
            values.push_back(column[row]);
        }
        starts.push_back(static_cast<CoinBigIndex>(values.size()));
    };
    for (const Eigen::Vector2d& point : points)
    {
        addColumn({1.0, point.x(), point.y()});
        sum += Eigen::Vector3d(1.0, point.x(), point.y());
    }
    addColumn(-sum);
    const std::vector<double> low(points.size() + 1, 0.0);
    const std::vector<double> high(points.size() + 1, 1e300);
    std::vector<double> costs(points.size() + 1, 0.0);
    costs.back() = 1.0;
    Clp_Simplex* clp = Clp_newModel();
    Clp_setLogLevel(clp, 0);
    Clp_loadProblem(clp, static_cast<int>(costs.size()), 3, starts.data(), rows.data(), values.data(), low.data(),
                    high.data(), costs.data(), load.data(), load.data());
    Clp_initialSolve(clp);
    const double pull = Clp_objectiveValue(clp);
    Clp_deleteModel(clp);
    return pull;
}

TEST(LeastPull, IsThatOfALinearProgram)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinates(-3.0, 3.0);
    int numPulling = 0;
    for (int run = 0; run < 300; ++run)
    {
        Points points;
        for (int point = 0; point < 3 + run % 7; ++point)
            points.emplace_back(coordinates(random), coordinates(random));
        const Eigen::Vector3d load(coordinates(random) + 1.0, coordinates(random), coordinates(random));
        const double pull = findLeastPull(load, points);
        EXPECT_NEAR(pull, solveByClp(load, points), 1e-6 * (1.0 + pull)) << run;
        numPulling += pull > 0.0;
    }
    EXPECT_GT(numPulling, 100);
    EXPECT_LT(numPulling, 300);
}

TEST(LeastPull, OfALoadOverThePointsIsNone)
{
    const Points corners{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}};
    EXPECT_EQ(findLeastPull({1.0, 1.9, 0.1}, corners), 0.0);
    EXPECT_EQ(findLeastPull({0.0, 0.0, 0.0}, corners), 0.0);
    EXPECT_DOUBLE_EQ(findLeastPull({-1.0, -1.0, -0.5}, corners), 0.25);
    // Beyond an edge by half of the width: the points of the other edge pull 1/4 each.
    EXPECT_DOUBLE_EQ(findLeastPull({1.0, 3.0, 0.5}, corners), 0.25);
}

TEST(LeastPull, OfPointsOnALineOrOfALoadThatIsNoNumberIsInfinite)
{
    EXPECT_TRUE(std::isinf(findLeastPull({1.0, 1.0, 1.0}, {{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}})));
    EXPECT_TRUE(std::isinf(
        findLeastPull({1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}, {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}})));
}

} // namespace

} // namespace osgLego::test
