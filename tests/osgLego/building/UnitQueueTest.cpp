#include <osgLego/building/UnitQueue.h>

#include <utility>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A queue of the parts that are not in place. */
class Queue
{
public:
    Queue(std::vector<BuildingBox> boxes, const std::vector<bool>& isPlaced) : _graph(std::move(boxes))
    {
        units.group(isPlaced, std::vector<bool>(_graph.getNumParts(), false));
    }

private:
    JointGraph _graph;
    Symmetry _symmetry{_graph.getBoxes()};
    PartOrder _order{_graph, _symmetry};

public:
    BuildingUnits units{_graph};
    UnitQueue create() { return {units, _order, _symmetry}; }
};

/** Two hooks, one above and below an arm of the other, that hang from a lid on a column; lid and column are in place.
 */
Queue createHooks()
{
    return {{{{0, 0, 9}, {6, 10, 10}},
             {{0, 8, 0}, {2, 10, 9}},
             {{0, 0, 8}, {6, 2, 9}},
             {{0, 0, 5}, {2, 2, 8}},
             {{0, 0, 4}, {6, 2, 5}},
             {{4, 0, 6}, {6, 6, 7}},
             {{4, 4, 7}, {6, 6, 9}}},
            {true, true, false, false, false, false, false}};
}

TEST(UnitQueue, InterlockedHooksThatNothingHoldsFromBelowArePlacedOneAfterTheOther)
{
    Queue hooks = createHooks();
    ASSERT_EQ(hooks.units.getUnits().size(), 2u);
    UnitQueue queue = hooks.create();
    UnitList all;
    while (!queue.isEmpty())
    {
        const UnitList units = queue.propose({});
        ASSERT_EQ(units.size(), 1u);
        ASSERT_LT(units[0], 2u);
        queue.take(units);
        all.push_back(units[0]);
    }
    ASSERT_EQ(all.size(), 2u);
    EXPECT_NE(all[0], all[1]);
}

TEST(UnitQueue, UnitsThatWouldHaveToBePlacedBeforeEachOtherAreNotAddedWithAllBefore)
{
    Queue hooks = createHooks();
    UnitList units;
    EXPECT_FALSE(hooks.create().addWithAllBefore(0, units));
}

TEST(UnitQueue, AddsAtMostTwelveUnitsBelowOne)
{
    constexpr int HEIGHT = 100;
    std::vector<BuildingBox> boxes;
    for (int z = 0; z < HEIGHT; ++z)
        boxes.push_back({{0, 0, z}, {2, 2, z + 1}});
    Queue column(boxes, std::vector<bool>(HEIGHT, false));
    const UnitQueue queue = column.create();
    UnitList units;
    EXPECT_TRUE(queue.addWithAllBefore(column.units.getUnitOf(11), units));
    ASSERT_EQ(units.size(), 12u);
    for (std::uint32_t z = 0; z < units.size(); ++z)
        EXPECT_EQ(units[z], column.units.getUnitOf(z));
    EXPECT_TRUE(queue.addWithAllBefore(column.units.getUnitOf(5), units)) << "it is among them";
    EXPECT_EQ(units.size(), 12u);
    for (const std::uint32_t z : {12u, 99u})
    {
        UnitList none;
        EXPECT_FALSE(queue.addWithAllBefore(column.units.getUnitOf(z), none)) << z;
        EXPECT_TRUE(none.empty()) << "the units are counted on the way down";
    }
}

/** The weight of the first step of islands of bricks 1x1, far from each other, each of which is a group. */
std::size_t weighFirstStep(const std::vector<int>& islands)
{
    std::vector<BuildingBox> boxes;
    for (std::size_t island = 0; island < islands.size(); ++island)
        for (int number = 0; number < islands[island]; ++number)
        {
            // Two sides of a square, so that nothing is symmetric.
            const bool isFirst = 2 * number < islands[island];
            const glm::ivec3 place(40 * static_cast<int>(island) + (isFirst ? number : 0),
                                   isFirst ? 0 : number - (islands[island] - 1) / 2, 0);
            boxes.push_back({place, place + 1});
        }
    const std::size_t numParts = boxes.size();
    Queue queue(std::move(boxes), std::vector<bool>(numParts, false));
    UnitQueue units = queue.create();
    return units.propose({}).size();
}

TEST(UnitQueue, StepsHaveEightPartsOrEndWithAGroupOrLeaveEnoughForTheNextStep)
{
    EXPECT_EQ(weighFirstStep({30}), 8u);
    EXPECT_EQ(weighFirstStep({7, 30}), 7u);
    EXPECT_EQ(weighFirstStep({9, 30}), 9u);
    EXPECT_EQ(weighFirstStep({10, 30}), 10u);
    EXPECT_EQ(weighFirstStep({11, 30}), 8u) << "more than ten parts are too many";
    EXPECT_EQ(weighFirstStep({5, 30}), 8u) << "of two equally good steps, the larger one";
    EXPECT_EQ(weighFirstStep({10, 7}), 10u);
    EXPECT_EQ(weighFirstStep({10, 4}), 8u) << "four parts would be too few for the last step";
    EXPECT_EQ(weighFirstStep({9, 3}), 7u) << "five parts are enough for the last step";
}

TEST(UnitQueue, APartAboveASubmodelIsNotInTheSameStep)
{
    // A column, in place, with a beam on it, three bricks below the beam, and one on it.
    Queue beam({{{0, 0, 0}, {2, 2, 2}},
                {{0, 0, 2}, {8, 2, 3}},
                {{6, 0, 1}, {8, 2, 2}},
                {{4, 0, 3}, {6, 2, 4}},
                {{2, 0, 1}, {4, 2, 2}},
                {{4, 0, 1}, {6, 2, 2}}},
               {true, false, false, false, false, false});
    const UnitQueue queue = beam.create();
    const std::uint32_t submodel = beam.units.getUnitOf(1);
    const std::uint32_t above = beam.units.getUnitOf(3);
    ASSERT_EQ(beam.units.getUnitOf(2), submodel);
    EXPECT_TRUE(queue.isOneStep({submodel}));
    EXPECT_TRUE(queue.isOneStep({above}));
    EXPECT_FALSE(queue.isOneStep({submodel, above}));
}

TEST(UnitQueue, APartAboveFewPartsInAHandIsInTheSameStep)
{
    // As above, with one brick below the beam.
    Queue beam({{{0, 0, 0}, {2, 2, 2}}, {{0, 0, 2}, {8, 2, 3}}, {{6, 0, 1}, {8, 2, 2}}, {{4, 0, 3}, {6, 2, 4}}},
               {true, false, false, false});
    const UnitQueue queue = beam.create();
    const std::uint32_t inHand = beam.units.getUnitOf(1);
    ASSERT_EQ(beam.units.getUnitOf(2), inHand);
    EXPECT_FALSE(queue.isSubmodel(inHand));
    EXPECT_EQ(queue.getWeight({inHand}), 2u);
    EXPECT_TRUE(queue.isOneStep({inHand, beam.units.getUnitOf(3)}));
}

/** The submodels in each step of a lid, in place on a column in its middle, from whose two ends chains hang. */
std::vector<std::size_t> countChainsOfSteps(int left, int right)
{
    constexpr int TOP = 20;
    std::vector<BuildingBox> boxes = {{{-2, 0, 0}, {2, 2, TOP}}, {{-20, 0, TOP}, {20, 2, TOP + 1}}};
    for (int z = TOP - left; z < TOP; ++z)
        boxes.push_back({{-20, 0, z}, {-18, 2, z + 1}});
    for (int z = TOP - right; z < TOP; ++z)
        boxes.push_back({{18, 0, z}, {20, 2, z + 1}});
    std::vector<bool> isPlaced(boxes.size(), false);
    isPlaced[0] = isPlaced[1] = true;
    Queue lid(std::move(boxes), isPlaced);
    UnitQueue queue = lid.create();
    std::vector<std::size_t> counts;
    while (!queue.isEmpty())
    {
        const UnitList units = queue.propose({});
        counts.push_back(units.size());
        queue.take(units);
    }
    return counts;
}

TEST(UnitQueue, StepsAttachOneLargeSubmodelOrTwoSmallOnesOrTwins)
{
    using Counts = std::vector<std::size_t>;
    EXPECT_EQ(countChainsOfSteps(13, 15), (Counts{1, 1}));
    EXPECT_EQ(countChainsOfSteps(15, 15), Counts{2}) << "twins";
    EXPECT_EQ(countChainsOfSteps(11, 12), Counts{2}) << "of the parts of one step each";
    EXPECT_EQ(countChainsOfSteps(12, 15), Counts{2}) << "one is too few for a step";
}

TEST(UnitQueue, LargeSubmodelsThatArePlacedAfterEachOtherAreOneStepIfNecessary)
{
    // A lid, in place on a column, from which three chains hang. The foot of each is below the next chain.
    constexpr int TOP = 20;
    std::vector<BuildingBox> boxes = {{{20, 0, 0}, {24, 2, TOP}}, {{0, 0, TOP}, {24, 2, TOP + 1}}};
    for (const int x : {0, 4, 8})
    {
        const int foot = 1 + x / 2;
        boxes.push_back({{x, 0, foot}, {x + 6, 2, foot + 1}});
        for (int z = foot + 1; z < TOP; ++z)
            boxes.push_back({{x, 0, z}, {x + 2, 2, z + 1}});
    }
    std::vector<bool> isPlaced(boxes.size(), false);
    isPlaced[0] = isPlaced[1] = true;
    Queue chains(boxes, isPlaced);
    ASSERT_EQ(chains.units.getUnits().size(), 3u);
    const UnitQueue queue = chains.create();
    UnitList units;
    EXPECT_TRUE(queue.addWithAllBefore(chains.units.getUnitOf(static_cast<std::uint32_t>(boxes.size()) - 1), units));
    EXPECT_EQ(units.size(), 3u);
    EXPECT_EQ(queue.countUnmirroredLarge(units), 2);
    EXPECT_EQ(queue.getWeight(units), 3 * UnitQueue::LARGE_WEIGHT);
}

TEST(UnitQueue, ASubmodelComesWhenItsLastPartWould)
{
    // A column with a beam, from which a leg hangs. Beside it is a slab with two towers, which begin above the foot of
    // the leg and below the beam.
    Queue model({{{0, 0, 0}, {2, 2, 3}},
                 {{0, 0, 3}, {8, 2, 4}},
                 {{6, 0, 1}, {8, 2, 3}},
                 {{0, 10, 0}, {9, 12, 2}},
                 {{0, 10, 2}, {2, 12, 3}},
                 {{7, 10, 2}, {9, 12, 3}}},
                std::vector<bool>(6, false));
    UnitQueue queue = model.create();
    const UnitList units = queue.propose({});
    ASSERT_EQ(units.size(), 5u);
    EXPECT_EQ(units.back(), model.units.getUnitOf(1));
    EXPECT_EQ(model.units.getUnitOf(1), model.units.getUnitOf(2));
}

} // namespace

} // namespace osgLego::test
