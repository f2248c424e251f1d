#include "BrickTowers.h"
#include "PlainEquilibrium.h"

#include <osgLego/stability/ContactFinder.h>
#include <osgLego/stability/TensionBound.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

constexpr double NO_LIMIT = std::numeric_limits<double>::infinity();

/** The largest pull of the forces that are found; nothing if none are. */
std::optional<double> findBound(const BrickModel& model, BuildingBase base, double capacity = StabilityReport::CAPACITY)
{
    const std::vector<PartBox> boxes = findPartBoxes(model);
    std::vector<Contact> contacts = findContacts(model);
    for (std::uint32_t part = 0; part < boxes.size(); ++part)
        if (boxes[part].low.z == 0)
            contacts.push_back({Contact::BASE, part, base == BuildingBase::TABLE ? Contact::TABLE : Contact::STUDS});
    std::vector<std::uint32_t> parts(boxes.size());
    std::iota(parts.begin(), parts.end(), 0u);
    const EquilibriumProgram program(boxes, parts, contacts);
    const std::optional<std::vector<double>> pulls = TensionBound(program, {}).find(capacity);
    if (!pulls) return std::nullopt;
    EXPECT_EQ(pulls->size(), contacts.size());
    return *std::max_element(pulls->begin(), pulls->end());
}

TEST(TensionBound, IsNotLessThanTheLeastTensionByClpAndIsFoundForMostTowersThatStand)
{
    int numStanding = 0;
    int numFound = 0;
    int numPulling = 0;
    for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
        for (unsigned int seed = 1; seed <= 60; ++seed)
        {
            const osg::ref_ptr<const BrickModel> tower = createRandomTower(seed, 6 + static_cast<int>(seed) % 25);
            const std::optional<double> least = computePlainTension(*tower, base);
            const std::optional<double> bound = findBound(*tower, base);
            const bool stands = least && *least <= StabilityReport::CAPACITY;
            EXPECT_TRUE(stands || !bound) << seed;
            EXPECT_GE(bound.value_or(NO_LIMIT), least.value_or(NO_LIMIT) - 1e-6) << seed;
            numStanding += stands;
            numFound += bound.has_value();
            numPulling += bound && *bound > 1e-3;
        }
    EXPECT_GT(numStanding, 30);
    EXPECT_GT(10 * numFound, 9 * numStanding) << numFound << " of " << numStanding;
    EXPECT_GT(numPulling, 10);
}

TEST(TensionBound, OfAModelWithOneWayToStandIsItsTension)
{
    // A brick 1 x 8 on a brick 1 x 1 on a base plate, with loads at its other end.
    for (const int numLoads : {0, 1, 2})
    {
        const osg::ref_ptr<const BrickModel> model = createLoadedCantilever(0, numLoads);
        const std::optional<double> least = computePlainTension(*model, BuildingBase::PLATE);
        ASSERT_TRUE(least);
        const std::optional<double> bound = findBound(*model, BuildingBase::PLATE, NO_LIMIT);
        ASSERT_TRUE(bound) << numLoads;
        EXPECT_NEAR(*bound, *least, 1e-6) << numLoads;
        EXPECT_TRUE(findBound(*model, BuildingBase::PLATE, *least + 1e-3));
        EXPECT_FALSE(findBound(*model, BuildingBase::PLATE, *least - 1e-3));
        // It topples off a table, which does not pull.
        EXPECT_FALSE(findBound(*model, BuildingBase::TABLE, NO_LIMIT));
    }
}

TEST(TensionBound, OfAWallThatJointsShareIsNearTheLeastTension)
{
    // A bond of bricks 1 x 4 that overhangs by one more stud in each layer.
    std::vector<Part> bricks;
    for (int layer = 0; layer < 6; ++layer)
        for (int brick = 0; brick < 4; ++brick)
            bricks.push_back(createBrick({4 * brick + layer, 0, layer}, 4, 1));
    const osg::ref_ptr<const BrickModel> wall = createPartModel(bricks);
    const std::optional<double> least = computePlainTension(*wall, BuildingBase::PLATE);
    ASSERT_TRUE(least);
    const std::optional<double> bound = findBound(*wall, BuildingBase::PLATE);
    ASSERT_TRUE(bound);
    EXPECT_GE(*bound, *least - 1e-6);
    EXPECT_LE(*bound, *least + 0.1);
}

} // namespace

} // namespace osgLego::test
