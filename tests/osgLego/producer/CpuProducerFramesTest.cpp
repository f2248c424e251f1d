#include <osgLego/CpuLegolizer.h>
#include <osgLego/LegoNode.h>
#include <osgLego/PartType.h>

#include <GlTest.h>
#include <Meshes.h>
#include <Notices.h>

#include <algorithm>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <string>
#include <thread>

#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

/** Counts notifications, and lets a test wait for one. */
class Announcements : public LegoNode::BricksCallback
{
public:
    void ready() override
    {
        const std::lock_guard lock(_mutex);
        ++_count;
        _changed.notify_all();
    }

    void waitFor(int count)
    {
        std::unique_lock lock(_mutex);
        _changed.wait(lock, [&] { return _count >= count; });
    }

private:
    ~Announcements() override = default;

    std::mutex _mutex;
    std::condition_variable _changed;
    int _count = 0;
};

/** A node in a viewer, whose bricks are made on the CPU while frames are drawn. */
class CpuProducerFramesTest : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _context = createContext();
        _contextID = _context->getState()->getContextID();
        _transform->addChild(createSphere(12));
        _lego->addChild(_transform);
        _lego->setSettings(parseSettings("16,device=cpu"));
        _lego->setBricksCallback(_announcements);
        setUpViewer(_viewer, *_context, *_lego);
    }

    osg::ref_ptr<osg::Image> drawFrame()
    {
        _viewer.frame();
        return readPixels(*_context);
    }

    unsigned int countShown() const { return _lego->getStatistics(_contextID).numLegolizations; }

    osg::ref_ptr<osg::GraphicsContext> _context;
    unsigned int _contextID = 0;
    osg::ref_ptr<osg::MatrixTransform> _transform = new osg::MatrixTransform;
    osg::ref_ptr<LegoNode> _lego = new LegoNode;
    osg::ref_ptr<Announcements> _announcements = new Announcements;
    osgViewer::Viewer _viewer;
};

TEST_F(CpuProducerFramesTest, TheFirstFrameWaitsForItsBricks)
{
    const osg::ref_ptr<osg::Image> first = drawFrame();
    EXPECT_GT(countDrawn(*first), 3000u);
    EXPECT_TRUE(_lego->isLegolized(_contextID));
}

TEST_F(CpuProducerFramesTest, ANodeShowsItsBricksUntilTheNewOnesAreReady)
{
    const osg::ref_ptr<osg::Image> before = drawFrame();
    _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, 0.5));
    EXPECT_EQ(countDifferent(*before, *drawFrame(), 0), 0u);
    EXPECT_FALSE(_lego->isLegolized(_contextID));
    _announcements->waitFor(2);
    const osg::ref_ptr<osg::Image> after = drawFrame();
    EXPECT_TRUE(_lego->isLegolized(_contextID));
    EXPECT_GT(countDifferent(*before, *after, 10), 500u);
    EXPECT_EQ(countShown(), 2u);
}

TEST_F(CpuProducerFramesTest, ANewerChangeReplacesAnOlderOne)
{
    drawFrame();
    _lego->setSettings(parseSettings("512,device=cpu"));
    _viewer.frame();
    _lego->setSettings(parseSettings("20,device=cpu"));
    _viewer.frame();
    EXPECT_EQ(countShown(), 1u);
    while (!_lego->isLegolized(_contextID))
        _viewer.frame();
    EXPECT_EQ(countShown(), 2u);
    EXPECT_EQ(_lego->getStatistics(_contextID).numDrawnBricks, _lego->getBricks()->getNumVisible());
}

TEST_F(CpuProducerFramesTest, BricksOfOtherSettingsAreNotThoseOfTheCurrentOnes)
{
    drawFrame();
    ASSERT_TRUE(_lego->isLegolized(_contextID));
    _lego->setSettings(parseSettings("16,device=cpu,look=full"));
    EXPECT_TRUE(_lego->isLegolized(_contextID)) << "the same bricks";
    _lego->setSettings(parseSettings("20,device=cpu"));
    EXPECT_FALSE(_lego->isLegolized(_contextID)) << "before the next frame";
    while (!_lego->isLegolized(_contextID))
        _viewer.frame();
    EXPECT_EQ(_lego->getStatistics(_contextID).numDrawnBricks, _lego->getBricks()->getNumVisible());
    EXPECT_EQ(_lego->getBricks()->getGrid().dimensions.x, 20);
    _lego->dirty();
    EXPECT_FALSE(_lego->isLegolized(_contextID)) << "after dirty()";
}

TEST_F(CpuProducerFramesTest, BeforeTheFirstBricksTheSettingChoosesThePicture)
{
    const osg::ref_ptr<osg::Image> bricks = drawFrame();
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(_transform);
    _viewer.setSceneData(group);
    const osg::ref_ptr<osg::Image> source = drawFrame();
    ASSERT_GT(countDifferent(*source, *bricks, 20), 1000u);
    for (const bool showsSource : {true, false})
    {
        _lego = new LegoNode(
            parseSettings(showsSource ? "16,device=cpu,meanwhile=source" : "16,device=cpu,meanwhile=nothing"));
        _lego->addChild(_transform);
        _lego->setBricksCallback(_announcements);
        _viewer.setSceneData(_lego);
        const osg::ref_ptr<osg::Image> first = drawFrame();
        EXPECT_FALSE(_lego->getShownBricks());
        EXPECT_FALSE(_lego->isLegolized(_contextID));
        if (showsSource)
            EXPECT_EQ(countDifferent(*first, *source, 0), 0u);
        else
            EXPECT_EQ(countDrawn(*first), 0u);
        while (!_lego->isLegolized(_contextID))
            _viewer.frame();
        EXPECT_EQ(countDifferent(*readPixels(*_context), *bricks, 0), 0u);
        ASSERT_TRUE(_lego->getShownBricks());
        EXPECT_EQ(_lego->getShownBricks(), _lego->getBricks());
    }
}

TEST_F(CpuProducerFramesTest, AFrameWaitsNoLongerThanTheLimit)
{
    _lego->setWaiting(true);
    ASSERT_TRUE(_lego->setWaitingLimit(0.0));
    drawFrame();
    EXPECT_FALSE(_lego->isLegolized(_contextID)) << "the first bricks";
    _lego->setWaitingLimit(60.0);
    drawFrame();
    EXPECT_TRUE(_lego->isLegolized(_contextID));
    const osg::ref_ptr<const BrickModel> before = _lego->getShownBricks();
    ASSERT_TRUE(before);
    // Takes longer than the limit and the frame.
    _lego->setSettings(parseSettings("600,device=cpu,parts=bricks,effort=best"));
    _lego->setWaitingLimit(0.001);
    drawFrame();
    EXPECT_FALSE(_lego->isLegolized(_contextID));
    EXPECT_EQ(_lego->getShownBricks(), before);
    _lego->setSettings(parseSettings("12,device=cpu"));
    _lego->setWaitingLimit(std::numeric_limits<double>::infinity());
    drawFrame();
    EXPECT_TRUE(_lego->isLegolized(_contextID));
    EXPECT_EQ(_lego->getShownBricks()->getGrid().dimensions.x, 12);
}

TEST_F(CpuProducerFramesTest, AWaitWithALimitEndsWhenItIsCancelled)
{
    _lego->setSettings(parseSettings("600,device=cpu,parts=bricks,effort=best"));
    _lego->setWaitingLimit(100000.0);
    std::thread canceller(
        [&]
        {
            while (_lego->getProgress().stage == LegoProgress::Stage::IDLE)
                std::this_thread::yield();
            _lego->cancel();
        });
    drawFrame();
    canceller.join();
    EXPECT_FALSE(_lego->isLegolized(_contextID));
}

TEST_F(CpuProducerFramesTest, ABadLimitIsRefused)
{
    _lego->setWaitingLimit(3.0);
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()})
    {
        const std::string notices = noticesOf([&] { EXPECT_FALSE(_lego->setWaitingLimit(bad)); });
        EXPECT_NE(notices.find("expected seconds from 0 on"), std::string::npos) << notices;
        EXPECT_EQ(_lego->getWaitingLimit(), 3.0);
    }
    const osg::ref_ptr<LegoNode> copy = osg::clone(_lego.get());
    EXPECT_EQ(copy->getWaitingLimit(), 3.0);
}

TEST_F(CpuProducerFramesTest, WithWaitingEachFrameShowsTheCurrentSource)
{
    _lego->setWaiting(true);
    drawFrame();
    for (const double height : {0.5, 0.8, 1.5})
    {
        _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, height));
        _viewer.frame();
        EXPECT_TRUE(_lego->isLegolized(_contextID)) << height;
    }
    EXPECT_EQ(countShown(), 4u);
}

TEST_F(CpuProducerFramesTest, AMovingSourceIsShownInRealParts)
{
    _lego->setSettings(parseSettings("24,parts=bricks,colors=4,effort=instant,device=cpu"));
    _lego->setWaiting(true);
    for (const double height : {1.0, 0.9, 0.8, 0.8, 0.5})
    {
        _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, height));
        _viewer.frame();
        const osg::ref_ptr<const BrickModel> shown = _lego->getBricks();
        const osg::ref_ptr<const BrickModel> cells =
            legolizeOnCpu(*_transform, parseSettings("24,proportions=brick,palette=ldraw,colors=4,device=cpu"));
        EXPECT_EQ(shown->getBricks(), cells->getBricks()) << height;
        EXPECT_LT(shown->getParts().size(), cells->getBricks().size()) << height;
        for (const Part& part : shown->getParts())
            ASSERT_TRUE(findPartType(part, shown->getGrid())) << height;
        EXPECT_EQ(_lego->getStatistics(_contextID).layout->numParts, shown->getParts().size());
    }
}

TEST_F(CpuProducerFramesTest, PartsFarFromAChangeAreKept)
{
    _lego->setSettings(parseSettings("cell=0.1,origin=0:0:0,proportions=brick,parts=bricks,colors=1,device=cpu"));
    _lego->setWaiting(true);
    drawFrame();
    const std::vector<Part> before = _lego->getBricks()->getParts();
    osg::ref_ptr<osg::MatrixTransform> horn = new osg::MatrixTransform(osg::Matrix::translate(0, 0, 1.2));
    horn->addChild(createTriangle({0, 0, 0}, {0.2f, 0, 0}, {0, 0, -0.4f}));
    _transform->addChild(horn);
    drawFrame();
    const std::vector<Part> after = _lego->getBricks()->getParts();
    ASSERT_NE(before, after);
    // The grid is the same below, so the lowest parts have the same cells.
    const auto isLow = [](const Part& part) { return part.cell[2] < 5; };
    const auto numLow = static_cast<std::size_t>(std::count_if(before.begin(), before.end(), isLow));
    const auto numKept = static_cast<std::size_t>(std::count_if(
        before.begin(), before.end(),
        [&](const Part& part) { return isLow(part) && std::find(after.begin(), after.end(), part) != after.end(); }));
    EXPECT_GT(numLow, 20u);
    EXPECT_EQ(numKept, numLow);
    // A layout without history differs there.
    const std::vector<Part> fresh = legolizeOnCpu(*_transform, _lego->getSettings())->getParts();
    EXPECT_TRUE(std::any_of(before.begin(), before.end(),
                            [&](const Part& part)
                            { return isLow(part) && std::find(fresh.begin(), fresh.end(), part) == fresh.end(); }));
}

TEST_F(CpuProducerFramesTest, AModelThatCannotBeFilledIsDrawnAsItIsWithTheReason)
{
    _lego->setSettings(parseSettings("600,fill=solid,device=cpu"));
    EXPECT_GT(countDrawn(*drawFrame()), 3000u);
    EXPECT_NE(_lego->getFailure(_contextID).find("cells; expected at most 67108864"), std::string::npos);
    _lego->setSettings(parseSettings("16,fill=solid,device=cpu"));
    drawFrame();
    EXPECT_TRUE(_lego->isLegolized(_contextID));
}

TEST_F(CpuProducerFramesTest, BoundsIncludeTheBricksShownAndTheBricksBeingMade)
{
    drawFrame();
    const osg::BoundingSphere before = _lego->getBound();
    _transform->setMatrix(osg::Matrix::translate(5.0, 0.0, 0.0));
    _viewer.frame();
    const osg::BoundingSphere between = _lego->getBound();
    EXPECT_GT(between.radius(), before.radius() + 2.0f);
    _announcements->waitFor(2);
    _viewer.frame();
    EXPECT_NEAR(_lego->getBound().radius(), before.radius(), 1e-3f);
    EXPECT_NEAR(_lego->getBound().center().x(), before.center().x() + 5.0f, 1e-3f);
}

TEST_F(CpuProducerFramesTest, WithoutTrianglesNothingIsShownAndOldBricksDoNotReturn)
{
    drawFrame();
    _lego->removeChild(_transform);
    EXPECT_EQ(countDrawn(*drawFrame()), 0u);
    _lego->addChild(createTorus());
    _viewer.frame();
    EXPECT_TRUE(_lego->isLegolized(_contextID)) << "without older bricks to show, new ones are waited for";
}

TEST_F(CpuProducerFramesTest, ASourceThatChangesInEveryFrameIsShownNowAndThen)
{
    // Its bricks take longer than a frame, so each frame finds a job still running.
    _lego->setSettings(parseSettings("300,device=cpu,look=plain"));
    drawFrame();
    for (int frame = 0; frame < 2000 && countShown() < 3; ++frame)
    {
        _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, 1.0 + 0.001 * frame));
        _viewer.frame();
    }
    EXPECT_GE(countShown(), 3u);
}

TEST_F(CpuProducerFramesTest, WithoutUpdateTraversalsNewSettingsAreShownToo)
{
    drawFrame();
    _lego->setSettings(parseSettings("20,device=cpu"));
    const auto renderFrame = [&]
    {
        _viewer.advance();
        _viewer.eventTraversal();
        _viewer.renderingTraversals();
    };
    renderFrame();
    _announcements->waitFor(2);
    renderFrame();
    EXPECT_TRUE(_lego->isLegolized(_contextID));
    EXPECT_EQ(countShown(), 2u);
}

TEST_F(CpuProducerFramesTest, ANodeMayBeDeletedWhileItsBricksAreBeingMade)
{
    drawFrame();
    _lego->setSettings(parseSettings("512,device=cpu"));
    _viewer.frame();
    _viewer.setSceneData(new osg::Group);
    _lego = nullptr;
    EXPECT_EQ(countDrawn(*drawFrame()), 0u);
}

} // namespace

} // namespace osgLego::test
