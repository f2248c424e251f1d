#include <osgLego/node/BuildingProducer.h>

#include <atomic>
#include <new>
#include <stdexcept>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

TEST(BuildingProducer, GivesUpASetWhoseModelCantBeMade)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    std::atomic<int> numAnnounced{0};
    BuildingProducer producer(*store,
                              [&]
                              {
                                  ++numAnnounced;
                                  numAnnounced.notify_all();
                              });
    BrickGrid grid;
    grid.dimensions = glm::ivec3(1);
    const osg::ref_ptr<const BrickSet> broken = new BrickSet(
        1, grid, []() -> osg::ref_ptr<const BrickModel> { throw std::runtime_error("there is no model"); });
    EXPECT_NO_THROW(producer.produce(*broken, BackgroundTask::FOREVER));
    const osg::ref_ptr<const BrickSet> huge =
        new BrickSet(2, grid, []() -> osg::ref_ptr<const BrickModel> { throw std::bad_alloc(); });
    EXPECT_NO_THROW(producer.produce(*huge, BackgroundTask::FOREVER));
    EXPECT_FALSE(store->getBuilding());
    EXPECT_EQ(numAnnounced, 0);

    // A later set is made all the same.
    const osg::ref_ptr<const BrickModel> model = BrickModel::create(grid, {Brick{}});
    producer.produce(*new BrickSet(3, *model, {}), BackgroundTask::FOREVER);
    ASSERT_TRUE(store->getBuilding());
    EXPECT_EQ(store->getBuilding()->getRevision(), 3u);
    numAnnounced.wait(0); // a set may be waited for before it is announced
    EXPECT_EQ(numAnnounced, 1);
}

} // namespace

} // namespace osgLego::test
