#include <osgLego/node/LoadProducer.h>

#include <atomic>
#include <set>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** Red bricks 2 x 2: a column, and one in the air. */
osg::ref_ptr<const BrickModel> createBricks()
{
    BrickGrid grid;
    grid.cellSize = {1.0, 1.0, 1.2};
    grid.dimensions = {12, 2, 2};
    std::vector<Part> parts(3);
    for (Part& part : parts)
    {
        part.size = {2, 2, 1};
        part.color = {200, 0, 0};
    }
    parts[1].cell = {0, 0, 1};
    parts[2].cell = {9, 0, 1};
    return BrickModel::createOfParts(grid, std::move(parts));
}

std::set<std::array<std::uint8_t, 3>> findColors(const BrickSet& bricks)
{
    std::set<std::array<std::uint8_t, 3>> colors;
    for (const BrickPoint& point : bricks.getPoints().points)
        colors.insert(unpackBrick(point).color);
    return colors;
}

TEST(LoadProducer, DeliversTheBricksInColorsForTheirLoad)
{
    const osg::ref_ptr<const BrickModel> model = createBricks();
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    std::atomic<int> numAnnounced = 0;
    LoadProducer producer(*store, [&] { ++numAnnounced; });
    producer.update(true);
    EXPECT_FALSE(store->getBricks());
    producer.produce(*model, 7);
    producer.update(true);
    const osg::ref_ptr<const BrickSet> bricks = store->getBricks();
    ASSERT_TRUE(bricks);
    EXPECT_EQ(bricks->getRevision(), 7u);
    EXPECT_EQ(bricks->getModel(), model);
    EXPECT_TRUE(bricks->getStatistics().isStored);
    // Blue for the column, in which nothing pulls, and magenta for the part that falls.
    EXPECT_EQ(findColors(*bricks), (std::set<std::array<std::uint8_t, 3>>{{49, 84, 190}, {220, 0, 200}}));
    EXPECT_EQ(numAnnounced, 1);
}

TEST(LoadProducer, ACancelledSetIsNotDelivered)
{
    const osg::ref_ptr<const BrickModel> model = createBricks();
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    LoadProducer producer(*store, {});
    producer.produce(*model, 1);
    producer.cancel();
    producer.update(true);
    EXPECT_FALSE(store->getBricks());
    producer.produce(*model, 2);
    producer.produce(*model, 3);
    producer.update(true);
    ASSERT_TRUE(store->getBricks());
    EXPECT_EQ(store->getBricks()->getRevision(), 3u);
}

} // namespace

} // namespace osgLego::test
