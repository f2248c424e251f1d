#include <osgLego/producer/CpuProducer.h>

#include <Meshes.h>
#include <Notices.h>
#include <Settings.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

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

/** A sphere of many colours. */
osg::ref_ptr<const LegoSource> createSource(const std::string& settingsText, std::uint64_t revision)
{
    std::string error;
    const osg::ref_ptr<LegoSource> source =
        LegoSource::create(*SceneTriangles::create(*createSphere()), parseSettings(settingsText), error);
    EXPECT_EQ(error, "");
    source->revision = revision;
    return source;
}

std::set<std::array<std::uint8_t, 3>> findColors(const BrickSet& bricks)
{
    std::set<std::array<std::uint8_t, 3>> colors;
    for (const BrickPoint& point : bricks.getPoints().points)
        colors.insert(unpackBrick(point).color);
    return colors;
}

class CpuProducerTest : public testing::Test
{
protected:
    CpuProducerTest() { _visitor->setState(new osg::State); }

    void expectCounts(std::size_t made, std::size_t failed, std::size_t cancelled)
    {
        EXPECT_EQ(_producer->getCounts().made, made);
        EXPECT_EQ(_producer->getCounts().failed, failed);
        EXPECT_EQ(_producer->getCounts().cancelled, cancelled);
    }

    const osg::ref_ptr<BrickStore> _store = new BrickStore;
    std::atomic<int> _numAnnounced{0};
    osg::ref_ptr<CpuProducer> _producer = new CpuProducer(*_store, [this] { ++_numAnnounced; });
    const osg::ref_ptr<osgUtil::CullVisitor> _visitor = new osgUtil::CullVisitor;
};

TEST_F(CpuProducerTest, DeliversTheBricksOfASource)
{
    _producer->produce(*createSource("16", 5), *_visitor, {BackgroundTask::FOREVER});
    ASSERT_TRUE(_store->getBricks());
    EXPECT_EQ(_store->getBricks()->getRevision(), 5u);
    expectCounts(1, 0, 0);
    _producer = nullptr; // waits for the thread, which announces the set after it has ended the wait for it
    EXPECT_EQ(_numAnnounced, 1);
}

TEST_F(CpuProducerTest, ASourceThatCannotBeFilledFails)
{
    _producer->produce(*createSource("600,fill=solid", 5), *_visitor, {BackgroundTask::FOREVER});
    EXPECT_FALSE(_store->getBricks());
    EXPECT_EQ(_store->getContext(0)->getFailedRevision(), 5u);
    EXPECT_NE(_store->getContext(0)->getFailure(), "");
    expectCounts(0, 1, 0);
}

TEST_F(CpuProducerTest, ACancelledSourceHasNotFailed)
{
    const osg::ref_ptr<const LegoSource> source = createSource("1024,proportions=plate,parts=bricks", 5);
    std::thread frame([&] { _producer->produce(*source, *_visitor, {BackgroundTask::FOREVER}); });
    // Again and again, because the frame may not have begun.
    while (_producer->getCounts().cancelled == 0 && _producer->getCounts().made == 0)
        _producer->cancel();
    frame.join();
    EXPECT_FALSE(_store->getBricks());
    EXPECT_EQ(_store->getContext(0)->getFailedRevision(), 0u);
    EXPECT_EQ(_store->getContext(0)->getFailure(), "");
    EXPECT_EQ(_numAnnounced, 0);
    expectCounts(0, 0, 1);
}

TEST_F(CpuProducerTest, EqualSourcesShareTheirBricksAndThePoints)
{
    const osg::ref_ptr<const LegoSource> source = createSource("16,parts=bricks", 5);
    const auto copy = [&](std::uint64_t revision, const char* settings)
    {
        std::string error;
        const LegoSettings other = parseSettings(settings);
        const osg::ref_ptr<LegoSource> copied =
            LegoSource::create(*source->triangles, other, SettingsPalette::read(other), error);
        copied->revision = revision;
        return copied;
    };
    const osg::ref_ptr<const LegoSource> equal = copy(7, "16,parts=bricks,look=plain");
    const osg::ref_ptr<const LegoSource> different = copy(7, "16,parts=bricks,seed=3");
    std::string error;
    const auto make = [&](const LegoSource& wanted)
    {
        const osg::ref_ptr<CpuProducer> producer = new CpuProducer(*new BrickStore, {});
        return std::pair(producer, producer->getBricks(wanted, error));
    };
    const auto [producer, first] = make(*source);
    ASSERT_TRUE(first);
    const auto [second, shared] = make(*equal);
    EXPECT_EQ(shared->getRevision(), 7u);
    EXPECT_EQ(shared->getModel(), first->getModel());
    EXPECT_EQ(&shared->getPoints(), &first->getPoints());
    EXPECT_EQ(shared->getLayoutStatistics()->numParts, first->getLayoutStatistics()->numParts);
    EXPECT_EQ(shared->getStatistics().numDrawnBricks, first->getStatistics().numDrawnBricks);
    EXPECT_NE(make(*different).second->getModel(), first->getModel());
}

TEST_F(CpuProducerTest, BricksThatKeepPartsOfEarlierOnesAreNotShared)
{
    std::string error;
    const osg::ref_ptr<const LegoSource> source = createSource("16,parts=bricks", 5);
    const osg::ref_ptr<const BrickSet> first = _producer->getBricks(*source, error);
    ASSERT_TRUE(first);
    _store->deliver(*first);
    _producer->update(0);
    const osg::ref_ptr<const LegoSource> later = createSource("16,parts=bricks", 7);
    ASSERT_NE(later->triangles, source->triangles);
    const osg::ref_ptr<const BrickSet> second = _producer->getBricks(*later, error);
    const osg::ref_ptr<CpuProducer> other = new CpuProducer(*new BrickStore, {});
    EXPECT_NE(other->getBricks(*later, error)->getModel(), second->getModel());
}

TEST_F(CpuProducerTest, OtherSettingsAlwaysCancel)
{
    std::uint64_t revision = 0;
    for (const char* settings : {"1024,proportions=plate,parts=bricks", "1000,proportions=plate,parts=bricks",
                                 "1000,proportions=plate,parts=bricks,show=load", "12"})
        _producer->produce(*createSource(settings, ++revision), *_visitor, {});
    _producer->finish();
    ASSERT_TRUE(_store->getBricks());
    EXPECT_EQ(_store->getBricks()->getRevision(), revision);
    _producer->cancel();
    while (_producer->getCounts().cancelled < 3)
        std::this_thread::yield();
    expectCounts(1, 0, 3);
}

TEST_F(CpuProducerTest, AChangedSourceDoesNotCancelTwiceInARow)
{
    std::vector<osg::ref_ptr<const LegoSource>> sources; // created before, since the first set must not be made earlier
    for (const std::uint64_t revision : {1, 2, 3, 4})
        sources.push_back(createSource("128,parts=bricks", revision));
    for (const osg::ref_ptr<const LegoSource>& source : sources)
        _producer->produce(*source, *_visitor, {});
    _producer->finish();
    ASSERT_TRUE(_store->getBricks());
    EXPECT_EQ(_store->getBricks()->getRevision(), 2u);
}

TEST_F(CpuProducerTest, WarnsOnceOfASettingWithoutEffect)
{
    const auto noticesOfRevision = [&](std::uint64_t revision, const char* fill)
    {
        std::string error;
        const osg::ref_ptr<LegoSource> source =
            LegoSource::create(*SceneTriangles::create(*createTriangle({0, 0, 0}, {3, 0, 0}, {0, 3, 3})),
                               parseSettings("8,fill=" + std::string(fill)), error);
        source->revision = revision;
        return noticesOf([&] { EXPECT_TRUE(_producer->getBricks(*source, error)); });
    };
    EXPECT_NE(noticesOfRevision(1, "solid").find("fill=solid adds no cells"), std::string::npos);
    EXPECT_EQ(noticesOfRevision(2, "solid"), "");
    EXPECT_NE(noticesOfRevision(3, "shell").find("fill=shell adds no cells"), std::string::npos);
}

TEST_F(CpuProducerTest, TellsTheProgressOfTheLayoutUntilItIsCancelled)
{
    EXPECT_EQ(_producer->getProgress().stage, LegoProgress::Stage::IDLE);
    const osg::ref_ptr<const LegoSource> source = createSource("96,parts=bricks", 5);
    std::string error;
    osg::ref_ptr<const BrickSet> bricks;
    std::thread maker([&] { bricks = _producer->getBricks(*source, error); });
    LegoProgress progress;
    while (_producer->getCounts().made == 0 && progress.fraction == 0.0f)
    {
        std::this_thread::yield();
        progress = _producer->getProgress();
    }
    EXPECT_EQ(progress.stage, LegoProgress::Stage::PARTS);
    EXPECT_GT(progress.fraction, 0.0f);
    EXPECT_LT(progress.fraction, 1.0f);
    _producer->cancel();
    maker.join();
    EXPECT_FALSE(bricks);
    EXPECT_EQ(error, "");
    expectCounts(0, 0, 1);
    EXPECT_EQ(_producer->getProgress().stage, LegoProgress::Stage::IDLE);
}

TEST_F(CpuProducerTest, StoredBricksGetColorsForTheirLoad)
{
    const osg::ref_ptr<const BrickModel> model = createBricks();
    _producer->finish();
    EXPECT_FALSE(_store->getBricks());
    _producer->produceByLoad(*model, 7);
    _producer->finish();
    const osg::ref_ptr<const BrickSet> bricks = _store->getBricks();
    ASSERT_TRUE(bricks);
    EXPECT_EQ(bricks->getRevision(), 7u);
    EXPECT_EQ(bricks->getModel(), model);
    EXPECT_TRUE(bricks->getStatistics().isStored);
    // Blue for the column, in which nothing pulls, and magenta for the part that falls.
    EXPECT_EQ(findColors(*bricks), (std::set<std::array<std::uint8_t, 3>>{{49, 84, 190}, {220, 0, 200}}));
    _producer = nullptr; // as above
    EXPECT_EQ(_numAnnounced, 1);
}

TEST_F(CpuProducerTest, BricksOfASourceGetColorsForTheirLoad)
{
    const osg::ref_ptr<const LegoSource> source = createSource("8,parts=bricks,show=load,effort=instant", 5);
    std::string error;
    const osg::ref_ptr<const BrickSet> bricks = _producer->getBricks(*source, error);
    ASSERT_TRUE(bricks) << error;
    const std::vector<Part>& parts = bricks->getModel()->getParts();
    ASSERT_FALSE(parts.empty());
    // The scale runs from blue over green and yellow to red; magenta is for parts that fall.
    for (const std::array<std::uint8_t, 3>& color : findColors(*bricks))
        EXPECT_TRUE(std::none_of(parts.begin(), parts.end(), [&](const Part& part) { return part.color == color; }))
            << int(color[0]) << ' ' << int(color[1]) << ' ' << int(color[2]);
}

TEST_F(CpuProducerTest, OnlyTheLastStoredBricksAreDelivered)
{
    const osg::ref_ptr<const BrickModel> model = createBricks();
    _producer->produceByLoad(*model, 1);
    _producer->cancel();
    _producer->finish();
    EXPECT_FALSE(_store->getBricks());
    for (const std::uint64_t revision : {2, 3, 4})
        _producer->produceByLoad(*model, revision);
    _producer->finish();
    ASSERT_TRUE(_store->getBricks());
    EXPECT_EQ(_store->getBricks()->getRevision(), 4u);
}

} // namespace

} // namespace osgLego::test
