#include "BrickCantilever.h"

#include <osgLego/stability/EquilibriumProgram.h>

#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double WEIGHT_1X1 = BrickCantilever::WEIGHT_1X1;
constexpr double WEIGHT_1X8 = BrickCantilever::WEIGHT_1X8;

void expectRows(const Eigen::VectorXd& rows, const std::vector<double>& expected)
{
    ASSERT_EQ(static_cast<std::size_t>(rows.size()), expected.size());
    for (std::size_t row = 0; row < expected.size(); ++row)
        EXPECT_NEAR(rows[static_cast<Eigen::Index>(row)], expected[row], 1e-12) << row;
}

/** The column of the only force of a kind whose wrench has the given torques. */
std::size_t findForce(const EquilibriumProgram& program, std::size_t joint, EquilibriumProgram::Kind kind,
                      double torqueX, double torqueY)
{
    std::vector<std::size_t> found;
    for (std::size_t force = program.getJoints()[joint].first; force < program.getJoints()[joint].end; ++force)
        if (program.getKind(force) == kind && program.getWrench(force)[3] == torqueX &&
            program.getWrench(force)[4] == torqueY)
            found.push_back(force);
    EXPECT_EQ(found.size(), 1u);
    return found.empty() ? 0 : found.front();
}

TEST(EquilibriumProgram, ItsLoadIsTheWeightsUpwards)
{
    expectRows(BrickCantilever::createProgram().getLoad(), {0, 0, WEIGHT_1X1, 0, 0, 0, 0, 0, WEIGHT_1X8, 0, 0, 0});
}

TEST(EquilibriumProgram, AStudHasFourPressuresFourDragsAndTwoFreeForces)
{
    const EquilibriumProgram program = BrickCantilever::createProgram();
    EXPECT_EQ(program.getNumBodies(), 2u);
    EXPECT_EQ(program.getNumRows(), 12u);
    EXPECT_EQ(program.getNumForces(), 20u);
    EXPECT_EQ(program.getNumDrags(), 8u);
    ASSERT_EQ(program.getJoints().size(), 2u);
    EXPECT_EQ(program.getJoints()[0].lower, 0);
    EXPECT_EQ(program.getJoints()[0].upper, 1);
    EXPECT_EQ(program.getJoints()[1].lower, EquilibriumProgram::NO_BODY);
    EXPECT_EQ(program.getJoints()[1].upper, 0);
}

TEST(EquilibriumProgram, SeveralStudsHaveAFreeTorqueAndPressureAtTheHullAlone)
{
    // Two studs of a part 1 x 2: of eight points, the two between the studs are within the hull of the others.
    const std::vector<PartBox> boxes{{{0, 0, 0}, {2, 1, 3}, 1.0}};
    const EquilibriumProgram program(boxes, std::vector<std::uint32_t>{0},
                                     std::vector<Contact>{{Contact::BASE, 0, Contact::STUDS}});
    EXPECT_EQ(program.getNumForces(), 6u + 8u + 3u);
    EXPECT_EQ(program.getNumDrags(), 8u);
    EXPECT_EQ(program.getKind(16), EquilibriumProgram::FREE);
    EXPECT_EQ(program.getWrench(16), Wrench::Unit(5));
}

TEST(EquilibriumProgram, ForcesFoundByHandKeepACantileverInEquilibrium)
{
    // The brick turns about the point a quarter pitch towards its end. Three drags hold it, whose distances from there
    // are 1/2, 1/4 and 1/4: each of them bears the weight times (3.5 - 1/4). Likewise below, where both weights act.
    const EquilibriumProgram program = BrickCantilever::createProgram();
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(20);
    const auto hold = [&](std::size_t joint, double drag, double pressure)
    {
        // The torque of a force upwards at (x, y) is (y, -x).
        forces[static_cast<Eigen::Index>(findForce(program, joint, EquilibriumProgram::PRESSURE, 0.0, -0.25))] =
            pressure;
        forces[static_cast<Eigen::Index>(findForce(program, joint, EquilibriumProgram::DRAG, 0.0, -0.25))] = drag;
        forces[static_cast<Eigen::Index>(findForce(program, joint, EquilibriumProgram::DRAG, -0.25, 0.0))] = drag;
        forces[static_cast<Eigen::Index>(findForce(program, joint, EquilibriumProgram::DRAG, 0.25, 0.0))] = drag;
    };
    const double upper = 3.25 * WEIGHT_1X8;
    hold(0, upper, WEIGHT_1X8 + 3.0 * upper);
    const double lower = 3.25 * WEIGHT_1X8 - 0.25 * WEIGHT_1X1;
    hold(1, lower, WEIGHT_1X8 + WEIGHT_1X1 + 3.0 * lower);
    Eigen::VectorXd rows(12);
    program.multiply(forces, rows);
    expectRows(rows, {0, 0, WEIGHT_1X1, 0, 0, 0, 0, 0, WEIGHT_1X8, 0, 0, 0});
}

TEST(EquilibriumProgram, AForceActsOnTheUpperPartAndItsOppositeOnTheLower)
{
    // A sideways force of 1 N at the joint, which is 0.6 pitches above one centre, and below the other and 3.5 to its
    // left.
    const EquilibriumProgram program = BrickCantilever::createProgram();
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(20);
    forces[9] = 1.0;
    ASSERT_EQ(program.getWrench(9), Wrench::Unit(1));
    Eigen::VectorXd rows(12);
    program.multiply(forces, rows);
    expectRows(rows, {0, -1, 0, 0.6, 0, 0, 0, 1, 0, 0.6, 0, -3.5});
}

TEST(EquilibriumProgram, NeighborsPressAtTheCornersWhereTheyTouch)
{
    // A brick 2 x 4 to the right of a brick 2 x 2: they touch at 2 x 1.2 pitches.
    const std::vector<PartBox> boxes{{{0, 0, 0}, {2, 2, 3}, 1.0}, {{2, 0, 0}, {4, 4, 3}, 1.0}};
    const EquilibriumProgram program(boxes, std::vector<std::uint32_t>{0, 1},
                                     std::vector<Contact>{{0, 1, Contact::SIDE_X}});
    ASSERT_EQ(program.getNumForces(), 4u);
    EXPECT_EQ(program.getNumDrags(), 0u);
    Eigen::VectorXd rows(12);
    program.multiply(Eigen::VectorXd::Ones(4), rows);
    // Each force acts at the middle of the touching sides on average, which is at y = 1.
    expectRows(rows, {-4, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 4});
    for (Eigen::Index force = 0; force < 4; ++force)
    {
        program.multiply(Eigen::VectorXd::Unit(4, force), rows);
        EXPECT_DOUBLE_EQ(std::abs(rows[4]), 0.6) << force;
        EXPECT_DOUBLE_EQ(std::abs(rows[5]), 1.0) << force;
        EXPECT_DOUBLE_EQ(rows[10], -rows[4]) << force;
        EXPECT_DOUBLE_EQ(rows[11], 1.0 - rows[5]) << force;
    }
}

TEST(EquilibriumProgram, ATableOnlyPresses)
{
    const std::vector<PartBox> boxes{{{0, 0, 0}, {2, 4, 3}, 1.0}};
    const EquilibriumProgram program(boxes, std::vector<std::uint32_t>{0},
                                     std::vector<Contact>{{Contact::BASE, 0, Contact::TABLE}});
    ASSERT_EQ(program.getNumForces(), 4u);
    for (Eigen::Index force = 0; force < 4; ++force)
    {
        EXPECT_EQ(program.getKind(static_cast<std::size_t>(force)), EquilibriumProgram::PRESSURE);
        Eigen::VectorXd rows(6);
        program.multiply(Eigen::VectorXd::Unit(4, force), rows);
        expectRows(rows.head<3>(), {0, 0, 1});
        EXPECT_DOUBLE_EQ(std::abs(rows[3]), 2.0);
        EXPECT_DOUBLE_EQ(std::abs(rows[4]), 1.0);
        EXPECT_DOUBLE_EQ(rows[5], 0.0);
    }
}

TEST(EquilibriumProgram, ForcesWorkAsMuchAsTheirSumsOnTheParts)
{
    // For any forces f and motions v of the parts, f * (A^T v) = (A f) * v.
    const EquilibriumProgram program = BrickCantilever::createProgram();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int round = 0; round < 10; ++round)
    {
        const Eigen::VectorXd forces = Eigen::VectorXd::NullaryExpr(20, [&] { return number(random); });
        const Eigen::VectorXd motion = Eigen::VectorXd::NullaryExpr(12, [&] { return number(random); });
        Eigen::VectorXd rows;
        Eigen::VectorXd rates;
        program.multiply(forces, rows);
        program.multiplyTransposed(motion, rates);
        EXPECT_NEAR(forces.dot(rates), rows.dot(motion), 1e-12);
    }
}

} // namespace

} // namespace osgLego::test
