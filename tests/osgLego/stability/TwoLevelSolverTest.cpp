#include <osgLego/stability/TwoLevelSolver.h>

#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Matrix = TwoLevelSolver::Matrix;

constexpr int COUNT = 3000;

/** Springs between each body of a chain and the next one; the first is fixed. */
Matrix createChain()
{
    std::vector<Eigen::Triplet<double>> entries;
    for (int body = 0; body < COUNT; ++body)
    {
        entries.emplace_back(body, body, 1.0);
        if (body == 0) continue;
        entries.emplace_back(body - 1, body - 1, 1.0);
        entries.emplace_back(body, body - 1, -1.0);
        entries.emplace_back(body - 1, body, -1.0);
    }
    Matrix chain(COUNT, COUNT);
    chain.setFromTriplets(entries.begin(), entries.end());
    return chain;
}

/** Each group of bodies moves by the same length. */
Matrix createMovements(int groupSize)
{
    Matrix movements(COUNT, (COUNT + groupSize - 1) / groupSize);
    for (int body = 0; body < COUNT; ++body)
        movements.insert(body, body / groupSize) = 1.0;
    return movements;
}

int countSteps(int groupSize)
{
    TwoLevelSolver solver(createMovements(groupSize));
    EXPECT_TRUE(solver.factorize(createChain(), {}));
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(COUNT);
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(COUNT);
    int numSteps = 0;
    EXPECT_TRUE(solver.solve(
        load, 1e-9,
        [&numSteps]
        {
            ++numSteps;
            return false;
        },
        solution));
    // The spring below a body bears it and all above.
    for (int body = 1; body < COUNT; ++body)
        EXPECT_NEAR(solution[body] - solution[body - 1], COUNT - body, 1e-4) << body;
    EXPECT_NEAR(solution[0], COUNT, 1e-4);
    return numSteps;
}

TEST(TwoLevelSolver, SolvesInFewStepsWhereGroupsMoveAsAWhole)
{
    // The incomplete factorization of a chain is complete; a single group adds an error that one step removes.
    EXPECT_LE(countSteps(COUNT), 5);
    EXPECT_LE(countSteps(10), 60);
}

TEST(TwoLevelSolver, SaysThatItHasBeenCancelled)
{
    TwoLevelSolver solver(createMovements(10));
    EXPECT_FALSE(solver.factorize(createChain(), [] { return true; }));
    ASSERT_TRUE(solver.factorize(createChain(), {}));
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(COUNT);
    EXPECT_FALSE(solver.solve(
        Eigen::VectorXd::Ones(COUNT), 1e-9, [] { return true; }, solution));
}

TEST(TwoLevelSolver, RefusesWhatIsNotPositiveDefinite)
{
    TwoLevelSolver solver(createMovements(10));
    EXPECT_FALSE(solver.factorize(-createChain(), {}));
}

} // namespace

} // namespace osgLego::test
