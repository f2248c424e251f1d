#include <osgLego/data/BuildingSet.h>

#include <BuildingOrders.h>
#include <PartModels.h>

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

using Cell = std::array<std::uint16_t, 3>;

/** The open sides of every visible cell of a model. */
std::map<Cell, int> findVisible(const BrickModel& model)
{
    std::map<Cell, int> result;
    for (const Brick& brick : model.getBricks())
        if (brick.openSides != 0) result[brick.cell] = brick.openSides;
    return result;
}

/** The open sides of every visible cell when some parts are in place, as the shaders decide. */
std::map<Cell, int> findVisible(const BuildingPoints& points, std::uint32_t numPlaced)
{
    std::map<Cell, int> result;
    for (std::size_t index = 0; index < points.points.size(); ++index)
    {
        const CellRanks& ranks = points.ranks[index];
        int sides = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            if (ranks.lower[axis] >= numPlaced) sides |= 1 << (2 * axis);
            if (ranks.upper[axis] >= numPlaced) sides |= 2 << (2 * axis);
        }
        if (ranks.own < numPlaced && sides != 0) result[unpackBrick(points.points[index]).cell] = sides;
    }
    return result;
}

osg::ref_ptr<const BrickModel> createModel(UpAxis up = UpAxis::Z)
{
    PartFilling filling;
    filling.heights = {1, 3};
    filling.isCovered = [](const glm::ivec3& cell) { return (cell.x * 7 + cell.y * 5 + cell.z * 3) % 11 != 0; };
    return createParts(createPartGrid({21, 19, 18}, 0.4, up), filling);
}

TEST(BuildingPoints, TellTheOpenSidesOfThePartsInPlace)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
    {
        const osg::ref_ptr<const BrickModel> model = createModel(up);
        const std::vector<std::uint32_t> order = createRandomOrder(*model, 3);
        const BuildingPoints points = createBuildingPoints(*model, createPlan(order)->getRanks());
        for (const std::size_t numPlaced :
             {std::size_t(0), std::size_t(1), order.size() / 3, order.size() - 1, order.size()})
            EXPECT_EQ(findVisible(points, static_cast<std::uint32_t>(numPlaced)),
                      findVisible(*createPlacedModel(*model, order, numPlaced)))
                << numPlaced;
    }
}

TEST(BuildingPoints, LeaveOutCellsThatAreNeverVisible)
{
    // A large part in the middle of others: the cell at its centre is always between cells of the same part.
    std::vector<Part> parts(1);
    parts[0].size = {3, 3, 3};
    const osg::ref_ptr<const BrickModel> model = BrickModel::createOfParts(createPartGrid({3, 3, 3}), parts);
    EXPECT_EQ(createBuildingPoints(*model, std::vector<std::uint32_t>{0}).points.size(), 26u);
}

TEST(BuildingPoints, BlocksContainTheirCellsAndKnowWhenTheseAreVisible)
{
    const osg::ref_ptr<const BrickModel> model = createModel();
    const std::vector<std::uint32_t> order = createRandomOrder(*model, 5);
    const BuildingPoints points = createBuildingPoints(*model, createPlan(order)->getRanks());
    std::size_t next = 0;
    ASSERT_GT(points.blocks.size(), 10u);
    for (const BrickBlock& block : points.blocks)
    {
        EXPECT_EQ(static_cast<std::size_t>(block.first), next);
        std::set<std::uint32_t> visible; // numbers of parts in place with which any of its cells is visible
        for (int index = 0; index < block.count; ++index, ++next)
        {
            const glm::ivec3 cell = unpackBrick(points.points[next]).getCell();
            const CellRanks& ranks = points.ranks[next];
            EXPECT_EQ(glm::clamp(cell, block.minimum, block.maximum), cell);
            const int open = unpackBrick(points.points[next]).openSides;
            EXPECT_EQ(block.openSides & open, open);
            EXPECT_EQ((open & SIDE_TOP) != 0, (block.openSides & SIDE_TOP) != 0) << "a stud among others";
            for (std::uint32_t numPlaced = 0; numPlaced <= order.size(); ++numPlaced)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if (ranks.own < numPlaced && (ranks.lower[axis] >= numPlaced || ranks.upper[axis] >= numPlaced))
                        visible.insert(numPlaced);
        }
        EXPECT_EQ(*visible.begin(), block.firstRank + 1);
        EXPECT_EQ(*visible.rbegin(), std::min<std::size_t>(block.lastRank, order.size()));
        EXPECT_LE(block.maximum.x - block.minimum.x, BrickPoints::BLOCK_SIDE);
    }
    EXPECT_EQ(next, points.points.size());
}

TEST(BuildingSet, ProgressIsTheRoundedShareOfParts)
{
    const osg::ref_ptr<const BrickModel> model = createModel();
    const std::size_t numParts = model->getParts().size();
    const osg::ref_ptr<const BuildingSet> building =
        new BuildingSet(1, *model, createPlan(createRandomOrder(*model, 2)));
    for (std::size_t numPlaced = 0; numPlaced <= numParts; ++numPlaced)
        EXPECT_EQ(building->getNumPlaced(static_cast<double>(numPlaced) / static_cast<double>(numParts)), numPlaced);
    EXPECT_EQ(building->getNumPlaced(0.49 / static_cast<double>(numParts)), 0u);
    EXPECT_EQ(building->getNumPlaced(0.51 / static_cast<double>(numParts)), 1u);
}

TEST(BuildingSet, BricksWithoutPartsArePlacedFromBottomToTop)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
    {
        const osg::ref_ptr<const BrickModel> cells = createCells(*createModel(up));
        const osg::ref_ptr<const BuildingSet> building = new BuildingSet(1, *cells, nullptr);
        const std::size_t axis = up == UpAxis::Y ? 1 : 2;
        const std::size_t numPlaced = cells->getBricks().size() / 2;
        const osg::ref_ptr<const BrickModel> placed = building->getPlacedModel(numPlaced);
        EXPECT_EQ(placed->getBricks().size(), numPlaced);
        std::size_t highest = 0;
        for (const Brick& brick : placed->getBricks())
            highest = std::max<std::size_t>(highest, brick.cell[axis]);
        for (const Brick& brick : cells->getBricks())
        {
            if (placed->find(brick.getCell())) continue;
            EXPECT_GE(brick.cell[axis], highest);
        }
    }
}

} // namespace

} // namespace osgLego::test
