#include <osgLego/store/BrickStore.h>

#include <cstdint>

#include <gtest/gtest.h>

namespace osgLego::test
{

namespace
{

/** A grid of two cells side by side: 2 x 1 x 1 pitches and a stud of 0.2125, that begins at `x`. */
BrickGrid createGrid(double x, double pitch = 1.0)
{
    BrickGrid grid;
    grid.origin = {x, 0.0, 0.0};
    grid.cellSize = glm::dvec3(pitch);
    grid.dimensions = {2, 1, 1};
    return grid;
}

osg::ref_ptr<const BrickModel> createModel(const BrickGrid& grid)
{
    return BrickModel::create(grid, {Brick{{0, 0, 0}}, Brick{{1, 0, 0}}});
}

/** A set made on the CPU. */
osg::ref_ptr<const BrickSet> createSet(std::uint64_t revision, const BrickGrid& grid)
{
    return new BrickSet(revision, *createModel(grid), LegoStatistics());
}

/** A set whose points are on a GPU. */
osg::ref_ptr<const BrickSet> createGpuSet(std::uint64_t revision, const BrickGrid& grid)
{
    return new BrickSet(revision, grid, [grid] { return createModel(grid); });
}

osg::ref_ptr<const BuildingSet> createBuilding(std::uint64_t revision)
{
    return new BuildingSet(revision, *createModel(createGrid(0.0)), nullptr);
}

void expectBounds(const BrickStore& store, double low, double high)
{
    const osg::BoundingBoxd bounds = store.getBounds();
    ASSERT_TRUE(bounds.valid());
    EXPECT_DOUBLE_EQ(bounds.xMin(), low);
    EXPECT_DOUBLE_EQ(bounds.xMax(), high);
}

TEST(BrickStore, IsEmptyAtFirst)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    EXPECT_FALSE(store->getBricks());
    EXPECT_FALSE(store->getBuilding());
    EXPECT_FALSE(store->getBounds().valid());
    EXPECT_TRUE(store->getState().isWhole());
}

TEST(BrickStore, KeepsTheNewestSetWhateverTheOrderOfDelivery)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    const osg::ref_ptr<const BrickSet> older = createSet(4, createGrid(0.0));
    const osg::ref_ptr<const BrickSet> newer = createSet(5, createGrid(1.0));
    store->deliver(*older);
    EXPECT_EQ(store->getBricks(), older);
    store->deliver(*newer);
    EXPECT_EQ(store->getBricks(), newer);
    store->deliver(*older);
    EXPECT_EQ(store->getBricks(), newer);
}

TEST(BrickStore, PrefersTheSetThatEveryContextCanUpload)
{
    const osg::ref_ptr<const BrickSet> fromCpu = createSet(4, createGrid(0.0));
    const osg::ref_ptr<const BrickSet> fromGpu = createGpuSet(4, createGrid(0.0));
    const osg::ref_ptr<BrickStore> first = new BrickStore;
    first->deliver(*fromCpu);
    first->deliver(*fromGpu);
    EXPECT_EQ(first->getBricks(), fromCpu);
    const osg::ref_ptr<BrickStore> second = new BrickStore;
    second->deliver(*fromGpu);
    second->deliver(*fromCpu);
    EXPECT_EQ(second->getBricks(), fromCpu);
}

TEST(BrickStore, ADraftReplacesTheSetForPickingOfItsSourceAlone)
{
    const osg::ref_ptr<const BrickSet> draft = createSet(3, createGrid(0.0));
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    store->deliver(*createGpuSet(4, createGrid(0.0)));
    store->deliver(*draft);
    EXPECT_EQ(store->getBricks(), draft);
    const osg::ref_ptr<const BrickSet> ofOtherSource = createGpuSet(6, createGrid(0.0));
    store->deliver(*ofOtherSource);
    store->deliver(*draft);
    EXPECT_EQ(store->getBricks(), ofOtherSource);
}

TEST(BrickStore, BoundsContainTheExpectedBricksUntilTheyAreDelivered)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    store->expect(1, createGrid(0.0));
    expectBounds(*store, 0.0, 2.0);
    EXPECT_DOUBLE_EQ(store->getBounds().zMax(), 1.2125) << "a stud of 1.7 mm, at a pitch of 8 mm";
    store->deliver(*createSet(1, createGrid(0.0)));
    store->expect(2, createGrid(5.0));
    expectBounds(*store, 0.0, 7.0);
    store->deliver(*createSet(2, createGrid(5.0)));
    expectBounds(*store, 5.0, 7.0);
}

TEST(BrickStore, ThePitchIsThatOfTheBricksThatTheNextFrameShows)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    store->expect(1, createGrid(0.0, 1.0));
    EXPECT_EQ(store->getPitch(), 1.0);
    store->deliver(*createSet(1, createGrid(0.0, 1.0)));
    store->expect(2, createGrid(0.0, 2.0));
    EXPECT_EQ(store->getPitch(), 1.0) << "the older set is still shown";
    store->deliver(*createGpuSet(2, createGrid(0.0, 2.0)));
    EXPECT_EQ(store->getPitch(), 2.0);
    store->expect(3, createGrid(0.0, 3.0));
    EXPECT_EQ(store->getPitch(), 3.0) << "the passes make the next set in the frame that is culled";
}

TEST(BrickStore, ClearingDropsEverythingAndRefusesOlderSets)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    store->expect(4, createGrid(0.0));
    store->deliver(*createSet(4, createGrid(0.0)));
    store->deliver(*createBuilding(4));
    store->clear(6);
    EXPECT_FALSE(store->getBricks());
    EXPECT_FALSE(store->getBuilding());
    EXPECT_FALSE(store->getBounds().valid());
    store->deliver(*createSet(5, createGrid(0.0)));
    store->deliver(*createBuilding(5));
    EXPECT_FALSE(store->getBricks());
    EXPECT_FALSE(store->getBuilding());
    const osg::ref_ptr<const BrickSet> newer = createSet(6, createGrid(0.0));
    store->deliver(*newer);
    EXPECT_EQ(store->getBricks(), newer);
}

TEST(BrickStore, KeepsTheNewestSetForDrawingPartlyBuilt)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    const osg::ref_ptr<const BuildingSet> first = createBuilding(4);
    const osg::ref_ptr<const BuildingSet> again = createBuilding(4);
    store->deliver(*first);
    EXPECT_EQ(store->getBuilding(), first);
    store->deliver(*again);
    EXPECT_EQ(store->getBuilding(), again) << "the same bricks in another order";
    store->deliver(*createBuilding(3));
    EXPECT_EQ(store->getBuilding(), again);
}

TEST(BrickStore, HoldsHowMuchIsShown)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    store->setState({0.25, 3});
    EXPECT_EQ(store->getState().progress, 0.25);
    EXPECT_EQ(store->getState().numNew, 3u);
    EXPECT_FALSE(store->getState().isWhole());
    EXPECT_FALSE((BuildingState{1.0, 2}).isWhole()) << "all parts are in place, and two are highlighted";
    EXPECT_FALSE((BuildingState{0.9, 0}).isWhole());
}

TEST(BrickStore, EachContextHasBricksOfItsOwn)
{
    const osg::ref_ptr<BrickStore> store = new BrickStore;
    const osg::ref_ptr<ContextBricks> first = store->getContext(3);
    EXPECT_TRUE(first->isEmpty());
    EXPECT_EQ(store->getContext(3), first);
    EXPECT_NE(store->getContext(4), first);
}

} // namespace

} // namespace osgLego::test
