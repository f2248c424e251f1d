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
    PartOrder _order{_graph.getBoxes(), _symmetry};

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

} // namespace

} // namespace osgLego::test
