#include "BrickTowers.h"

#include <osgLego/stability/ComponentSolver.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** Solve a column of bricks 2 x 2 on a table. @param mass of the topmost one, in grams. */
std::optional<ComponentStability> solveColumn(std::uint32_t count, double mass,
                                              const std::function<bool()>& isCancelled = {})
{
    std::vector<Part> bricks;
    for (std::uint32_t part = 0; part < count; ++part)
        bricks.push_back(createBrick({0, 0, static_cast<int>(part)}, 2, 2));
    const osg::ref_ptr<const BrickModel> model = createPartModel(std::move(bricks));
    std::vector<PartBox> boxes = findPartBoxes(*model);
    boxes.back().mass = mass;
    std::vector<Contact> contacts = findContacts(*model);
    contacts.push_back({Contact::BASE, 0, Contact::TABLE});
    std::vector<std::uint32_t> parts(count);
    std::iota(parts.begin(), parts.end(), 0u);
    return solveComponent(boxes, parts, contacts, isCancelled);
}

TEST(ComponentSolver, PiecesWhoseForcesCantBeComputedAreUnknownRatherThanFalling)
{
    EXPECT_TRUE(solveColumn(3, 1.0)->isKnown);
    EXPECT_FALSE(solveColumn(3, 1.0)->isTensionBound);
    // The least error of 1e15 g in double precision is larger than the tolerance of the forces.
    for (const double mass :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e200, 1e15})
    {
        const std::optional<ComponentStability> result = solveColumn(3, mass);
        ASSERT_TRUE(result);
        EXPECT_FALSE(result->isKnown) << mass;
        EXPECT_TRUE(result->falling.empty()) << mass;
        ASSERT_EQ(result->loads.size(), 3u);
        EXPECT_TRUE(std::isnan(result->loads[0])) << mass;
    }
}

/** Solve a model on a base plate, with its parts and contacts numbered at random: the order of elimination depends on
 * that. @param seed 0 keeps the numbers. */
ComponentStability solveInRandomOrder(const BrickModel& model, unsigned int seed)
{
    const std::vector<PartBox> boxes = findPartBoxes(model);
    std::vector<Contact> contacts = findContacts(model);
    for (std::uint32_t part = 0; part < boxes.size(); ++part)
        if (boxes[part].low.z == 0) contacts.push_back({Contact::BASE, part, Contact::STUDS});
    std::vector<std::uint32_t> parts(boxes.size());
    std::iota(parts.begin(), parts.end(), 0u);
    std::vector<std::uint32_t> numbers = parts;
    std::mt19937 random(seed);
    if (seed > 0)
    {
        std::shuffle(numbers.begin(), numbers.end(), random);
        std::shuffle(contacts.begin(), contacts.end(), random);
    }
    std::vector<PartBox> numbered(boxes.size());
    for (const std::uint32_t part : parts)
        numbered[numbers[part]] = boxes[part];
    for (Contact& contact : contacts)
    {
        contact.upper = numbers[contact.upper];
        if (contact.lower != Contact::BASE) contact.lower = numbers[contact.lower];
    }
    return *solveComponent(numbered, parts, contacts, {});
}

TEST(ComponentSolver, TheOrderOfEliminationChangesNeitherVerdictNorTension)
{
    // Some of them close to the limit, and with long levers, where rounding errors are large.
    std::vector<osg::ref_ptr<const BrickModel>> models{createLoadedCantilever(2, 3)};
    for (const int height : {100, 112, 114, 116, 126})
    {
        std::vector<Part> column{createBrick({3, 0, 0}, 1, 1)};
        for (int z = 1; z < height; ++z)
            column.push_back(createBrick({3, 0, z}, 3, 1));
        models.push_back(createPartModel(std::move(column)));
    }
    for (unsigned int seed = 1; seed <= 30; ++seed)
        models.push_back(createRandomTower(seed, 4 + static_cast<int>(seed)));
    int numStanding = 0;
    for (std::size_t index = 0; index < models.size(); ++index)
    {
        const ComponentStability expected = solveInRandomOrder(*models[index], 0);
        EXPECT_TRUE(expected.isKnown) << index;
        numStanding += expected.falling.empty();
        for (unsigned int seed = 1; seed <= 5; ++seed)
        {
            const ComponentStability result = solveInRandomOrder(*models[index], seed);
            EXPECT_TRUE(result.isKnown) << index << ", " << seed;
            EXPECT_EQ(result.falling.empty(), expected.falling.empty()) << index << ", " << seed;
            if (std::isinf(expected.tension))
                EXPECT_EQ(result.tension, expected.tension) << index << ", " << seed;
            else
                EXPECT_NEAR(result.tension, expected.tension, 2e-6) << index << ", " << seed;
        }
    }
    EXPECT_GT(numStanding, 10);
    EXPECT_LT(numStanding, static_cast<int>(models.size()));
}

/** Solve a cantilever on a base plate: a part 1 x 8 on the single stud of a brick 1 x 1.
 * @param height of the part, in pitches. @param tension that holds it, in newtons. */
ComponentStability solveCantilever(double height, double tension)
{
    constexpr double NEWTONS_PER_GRAM = 9.8e-3;
    constexpr double LEVER = 3.25; // pitches; see Stability.ACantileverIsHeldByThreePointsOfItsStud
    constexpr double PLATES_PER_PITCH = 2.5;
    const std::vector<PartBox> boxes{
        {{0, 0, 0}, {1, 1, 3}, 0.43},
        {{0, 0, 3}, {8, 1, 3 + static_cast<int>(PLATES_PER_PITCH * height)}, tension / (NEWTONS_PER_GRAM * LEVER)}};
    return *solveComponent(boxes, std::vector<std::uint32_t>{0, 1},
                           std::vector<Contact>{{0, 1, Contact::STUDS}, {Contact::BASE, 0, Contact::STUDS}}, {});
}

TEST(ComponentSolver, FindsTheTensionEvenIfASmallForceAtALongLeverCouldSaveIt)
{
    // A force sideways at the middle of the part, whose lever is half of the height, would save the tension.
    for (const double height : {10.0, 1e3, 1e4})
    {
        const ComponentStability result = solveCantilever(height, 0.9);
        EXPECT_TRUE(result.falling.empty()) << height;
        EXPECT_NEAR(result.tension, 0.9, 1e-6) << height;
    }
}

TEST(ComponentSolver, CanBeCancelledWithinAFactorization)
{
    constexpr std::uint32_t NUM_PARTS = 30;
    int numCalls = 0;
    const auto count = [&] { return ++numCalls < 0; };
    ASSERT_TRUE(solveColumn(NUM_PARTS, 1.0, count));
    // In the analysis, once for each part; at the start and in each iteration, several times.
    ASSERT_GE(numCalls, static_cast<int>(NUM_PARTS) + 10);
    for (int last = 1; last <= numCalls; ++last)
    {
        int calls = 0;
        EXPECT_FALSE(solveColumn(NUM_PARTS, 1.0, [&] { return ++calls == last; }));
        EXPECT_EQ(calls, last);
    }
}

TEST(ComponentSolver, TheWeakestJointIsTheOneWhoseCapacityMattersMost)
{
    // A part 1 x 12 on two bricks 1 x 1 on a base plate, below its first and its third stud. It turns about the third,
    // as in BrickCantilever, where the levers of the drags add up to 1. Those at the first stud are 2, 2.25, 2.25 and
    // 2.5, so that its capacity matters 9 times as much.
    constexpr double WEIGHT = 9.8e-3 * 30.0; // newtons
    const std::vector<PartBox> boxes{
        {{0, 0, 0}, {1, 1, 3}, 0.43}, {{2, 0, 0}, {3, 1, 3}, 0.43}, {{0, 0, 3}, {12, 1, 6}, 30.0}};
    std::vector<Contact> contacts{{0, 2, Contact::STUDS},
                                  {1, 2, Contact::STUDS},
                                  {Contact::BASE, 0, Contact::STUDS},
                                  {Contact::BASE, 1, Contact::STUDS}};
    for (const bool isLast : {false, true})
    {
        if (isLast) std::swap(contacts[0], contacts[1]);
        const ComponentStability result = *solveComponent(boxes, std::vector<std::uint32_t>{0, 1, 2}, contacts, {});
        EXPECT_NEAR(result.tension, WEIGHT * (6.0 - 2.75) / 10.0, 1e-6);
        ASSERT_TRUE(result.weakest);
        EXPECT_EQ(result.weakest->lower, 0u) << isLast;
        EXPECT_EQ(result.weakest->upper, 2u) << isLast;
    }
}

} // namespace

} // namespace osgLego::test
