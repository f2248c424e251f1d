#include "BrickCantilever.h"
#include "BrickTowers.h"

#include <osgLego/stability/InteriorPointSolver.h>

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double PENALTY = 1e4;

TEST(InteriorPointSolver, FindsTheLeastTensionOfACantilever)
{
    const EquilibriumProgram program = BrickCantilever::createProgram();
    const Equilibrium result = *InteriorPointSolver(program).solve({PENALTY, 0.98, true});
    EXPECT_TRUE(result.hasConverged);
    EXPECT_NEAR(result.tension, BrickCantilever::WEIGHT_1X8 * BrickCantilever::LEVER, 1e-7);
    EXPECT_LT(result.residuals.abs().maxCoeff(), 1e-8);
    Eigen::VectorXd rows;
    program.multiply(result.forces.matrix(), rows);
    EXPECT_LT((rows - program.getLoad()).cwiseAbs().maxCoeff(), 1e-7);
    for (std::size_t force = 0; force < program.getNumForces(); ++force)
    {
        if (program.getKind(force) == EquilibriumProgram::FREE) continue;
        EXPECT_GE(result.forces[static_cast<Eigen::Index>(force)], 0.0) << force;
        const bool isDrag = program.getKind(force) == EquilibriumProgram::DRAG;
        EXPECT_TRUE(!isDrag || result.forces[static_cast<Eigen::Index>(force)] <= result.tension) << force;
    }
}

TEST(InteriorPointSolver, FindsTheLeastForceThatIsMissing)
{
    // With a tension of 0.05 N, the cheapest help is a force that carries a share of the weight at the brick's centre.
    constexpr double TENSION = 0.05;
    const EquilibriumProgram program = BrickCantilever::createProgram();
    const Equilibrium result = *InteriorPointSolver(program).solve({1.0, TENSION, false});
    EXPECT_TRUE(result.hasConverged);
    EXPECT_EQ(result.tension, TENSION);
    EXPECT_NEAR(result.residuals[8], BrickCantilever::WEIGHT_1X8 - TENSION / BrickCantilever::LEVER, 1e-6);
    EXPECT_NEAR(result.residuals.abs().sum(), BrickCantilever::WEIGHT_1X8 - TENSION / BrickCantilever::LEVER, 1e-6);
}

TEST(InteriorPointSolver, DoesNotExceedTheCapacityWhenItMinimizesTheTension)
{
    const EquilibriumProgram program = BrickCantilever::createProgram();
    const Equilibrium result = *InteriorPointSolver(program).solve({PENALTY, 0.05, true});
    EXPECT_TRUE(result.hasConverged);
    EXPECT_NEAR(result.tension, 0.05, 1e-7);
    EXPECT_NEAR(result.residuals.abs().sum(), BrickCantilever::WEIGHT_1X8 - 0.05 / BrickCantilever::LEVER, 1e-6);
}

TEST(InteriorPointSolver, MayEndOnceItIsCertainThatSomethingIsMissing)
{
    const EquilibriumProgram program = BrickCantilever::createProgram();
    EquilibriumGoal goal{PENALTY, 0.05, true};
    const Equilibrium whole = *InteriorPointSolver(program).solve(goal);
    goal.endsIfMissing = true;
    const Equilibrium early = *InteriorPointSolver(program).solve(goal);
    EXPECT_FALSE(early.hasConverged);
    EXPECT_LT(early.numIterations, whole.numIterations);
    EXPECT_GT(early.residuals.abs().sum(), 1e-3);
    goal.capacity = 0.98;
    EXPECT_TRUE(InteriorPointSolver(program).solve(goal)->hasConverged);
}

TEST(InteriorPointSolver, DoesWithoutForcesThatCostLessThanTheyAvoidTension)
{
    // A newton that is missing saves 3.25 N of tension: that pays if it costs 3 N, and not if it costs 3.5 N.
    const EquilibriumProgram program = BrickCantilever::createProgram();
    InteriorPointSolver solver(program);
    const Equilibrium loose = *solver.solve({3.0, 0.98, true});
    EXPECT_NEAR(loose.tension, 0.0, 1e-6);
    EXPECT_NEAR(loose.residuals[8], BrickCantilever::WEIGHT_1X8, 1e-5);
    const Equilibrium held = *solver.solve({3.5, 0.98, true});
    EXPECT_NEAR(held.tension, BrickCantilever::WEIGHT_1X8 * BrickCantilever::LEVER, 1e-6);
    EXPECT_NEAR(held.residuals.abs().sum(), 0.0, 1e-6);
}

TEST(InteriorPointSolver, PricesAreWhatMoreOfEachDragWouldSave)
{
    // A force saves as much of the missing one as its share of the lever.
    const EquilibriumProgram program = BrickCantilever::createProgram();
    const Equilibrium result = *InteriorPointSolver(program).solve({1.0, 0.05, false});
    const EquilibriumProgram::Joint& joint = program.getJoints()[0];
    for (std::size_t force = joint.first; force < joint.end; ++force)
    {
        const double price = result.prices[static_cast<Eigen::Index>(force)];
        if (program.getKind(force) != EquilibriumProgram::DRAG)
        {
            EXPECT_EQ(price, 0.0) << force;
            continue;
        }
        // The torque of a drag at (x, y) is (-y, x).
        const double distance = 0.25 - program.getWrench(force)[4];
        EXPECT_NEAR(price, distance / BrickCantilever::LEVER, 1e-4) << force;
    }
}

TEST(InteriorPointSolver, HeavyModelsTakeFewSteps)
{
    // More newtons are missing at the start. If the products of other variables and their dual slacks were not as large
    // as the cost of these, the first steps would be short, and 186 in all.
    int numSteps = 0;
    for (unsigned int seed = 1; seed <= 10; ++seed)
    {
        const osg::ref_ptr<const BrickModel> model = createRandomTower(seed, 4 + 2 * static_cast<int>(seed));
        std::vector<PartBox> boxes = findPartBoxes(*model);
        std::vector<Contact> contacts = findContacts(*model);
        std::vector<std::uint32_t> parts;
        for (std::uint32_t part = 0; part < boxes.size(); ++part)
        {
            boxes[part].mass *= 10.0;
            parts.push_back(part);
            if (boxes[part].low.z == 0) contacts.push_back({Contact::BASE, part, Contact::STUDS});
        }
        const EquilibriumProgram program(boxes, parts, contacts);
        const Equilibrium result = *InteriorPointSolver(program).solve({PENALTY, 0.98, true});
        EXPECT_TRUE(result.hasConverged) << seed;
        numSteps += result.numIterations;
    }
    EXPECT_LE(numSteps, 150);
}

TEST(InteriorPointSolver, ProgramsWithoutDragsHaveNoTensionToMinimize)
{
    const std::vector<PartBox> boxes{{{0, 0, 0}, {2, 2, 3}, 1.15}};
    const EquilibriumProgram program(boxes, std::vector<std::uint32_t>{0},
                                     std::vector<Contact>{{Contact::BASE, 0, Contact::TABLE}});
    const Equilibrium result = *InteriorPointSolver(program).solve({PENALTY, 0.98, true});
    EXPECT_TRUE(result.hasConverged);
    EXPECT_NEAR(result.forces.sum(), 9.8e-3 * 1.15, 1e-7);
    EXPECT_LT(result.residuals.abs().maxCoeff(), 1e-8);
}

} // namespace

} // namespace osgLego::test
