#include <osgLego/CpuLegolizer.h>
#include <osgLego/LegoNode.h>
#include <osgLego/flattening/LegoSource.h>
#include <osgLego/flattening/SceneTriangles.h>
#include <osgLego/model/CpuBricks.h>

#include <GlTest.h>
#include <Meshes.h>

#include <array>
#include <string>
#include <vector>

#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

/** Parts that take longer than any test, and the same with the effort of drafts. */
constexpr const char* LAID_LONG = "64,parts=bricks,fill=solid,effort=best,device=cpu";
constexpr const char* LAID_AT_ONCE = "64,parts=bricks,fill=solid,effort=instant,device=cpu";

/** The parts of drafts of a source, while it moves and while it rests. */
std::array<std::vector<Part>, 2> layDrafts(const osg::Node& node, const LegoSettings& settings)
{
    std::array<std::vector<Part>, 2> drafts;
    std::string error;
    const osg::ref_ptr<const LegoSource> source = createFirstSource(*SceneTriangles::create(node), settings, error);
    for (const bool isMoving : {true, false})
    {
        std::vector<Part>& parts = drafts[isMoving ? 0 : 1];
        CpuBricksWork work;
        work.isDraftGreedy = isMoving;
        work.showDraft = [&](const BrickModel& draft, PreviousLayout&&) { parts = draft.getParts(); };
        work.isCancelled = [&] { return !parts.empty(); };
        makeBricksOnCpu(*source, work);
    }
    return drafts;
}

/** The bricks whose colours are those of the surface; interior ones have any colour. */
std::vector<Brick> selectVisible(const BrickModel& model)
{
    std::vector<Brick> bricks = model.getBricks();
    std::erase_if(bricks, [](const Brick& brick) { return brick.openSides == 0; });
    return bricks;
}

/** A node in a viewer that shows drafts of its parts. */
class DraftFramesTest : public GlTest
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
        setUpViewer(_viewer, *_context, *_lego);
    }

    osg::ref_ptr<osg::Image> drawFrame()
    {
        _viewer.frame();
        return readPixels(*_context);
    }

    osg::ref_ptr<const BrickModel> drawUntilOthersAreShown(const BrickModel& model)
    {
        while (_lego->getShownBricks() == &model)
            _viewer.frame();
        return _lego->getShownBricks();
    }

    unsigned int countShown() const { return _lego->getStatistics(_contextID).numLegolizations; }

    osg::ref_ptr<osg::GraphicsContext> _context;
    unsigned int _contextID = 0;
    osg::ref_ptr<osg::MatrixTransform> _transform = new osg::MatrixTransform;
    osg::ref_ptr<LegoNode> _lego = new LegoNode;
    osgViewer::Viewer _viewer;
};

TEST_F(DraftFramesTest, ADraftIsShownUntilThePartsAreLaid)
{
    drawFrame();
    _lego->setSettings(parseSettings(LAID_LONG));
    const osg::ref_ptr<const BrickModel> draft = drawUntilOthersAreShown(*_lego->getShownBricks());
    EXPECT_FALSE(_lego->isLegolized(_contextID));
    EXPECT_EQ(_lego->getProgress().stage, LegoProgress::Stage::PARTS);
    // The change counts as a movement if the first frame was drawn within 0.2 seconds (MotionPace).
    const auto [moving, resting] = layDrafts(*_transform, parseSettings(LAID_LONG));
    EXPECT_EQ(resting, legolizeOnCpu(*_transform, parseSettings(LAID_AT_ONCE))->getParts());
    EXPECT_NE(moving, resting);
    EXPECT_TRUE(draft->getParts() == moving || draft->getParts() == resting);
    EXPECT_EQ(_lego->getStatistics(_contextID).numDrawnBricks, draft->getNumVisible());

    _lego->setSettings(parseSettings("20,parts=bricks,device=cpu"));
    while (!_lego->isLegolized(_contextID))
        _viewer.frame();
    const osg::ref_ptr<const BrickModel> laid = legolizeOnCpu(*_transform, _lego->getSettings());
    EXPECT_EQ(_lego->getShownBricks()->getParts(), laid->getParts());
}

TEST_F(DraftFramesTest, EachChangeOfASourceIsShownAsADraft)
{
    drawFrame();
    _lego->setSettings(parseSettings(LAID_LONG));
    osg::ref_ptr<const BrickModel> shown = drawUntilOthersAreShown(*_lego->getShownBricks());
    for (const double height : {0.9, 0.8, 0.7, 0.6})
    {
        _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, height));
        shown = drawUntilOthersAreShown(*shown);
        const osg::ref_ptr<const BrickModel> expected = legolizeOnCpu(*_transform, parseSettings(LAID_AT_ONCE));
        EXPECT_EQ(selectVisible(*shown), selectVisible(*expected)) << height;
    }
    EXPECT_FALSE(_lego->isLegolized(_contextID));
}

TEST_F(DraftFramesTest, ASourceThatRestsAfterAMovementHasThePartsOfTheSettings)
{
    for (const char* effort : {"instant", "normal"})
    {
        _lego->setSettings(parseSettings("20,parts=bricks,device=cpu,effort=" + std::string(effort)));
        for (const double height : {0.9, 0.8, 0.7, 0.6})
        {
            _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, height));
            _viewer.frame();
        }
        while (!_lego->isLegolized(_contextID))
            _viewer.frame();
        const osg::ref_ptr<const BrickModel> expected = legolizeOnCpu(*_transform, _lego->getSettings());
        EXPECT_EQ(selectVisible(*_lego->getShownBricks()), selectVisible(*expected)) << effort;
        EXPECT_LT(_lego->getShownBricks()->getParts().size(), 1.05 * static_cast<double>(expected->getParts().size()))
            << effort;
    }
}

TEST_F(DraftFramesTest, EvenWhileASourceMovesAProgramGetsTheBricksOfTheMoment)
{
    drawFrame();
    _lego->setSettings(parseSettings("20,parts=bricks,device=cpu"));
    for (const double height : {0.9, 0.8, 0.7, 0.6})
    {
        _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, height));
        _viewer.frame();
        _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, height - 0.05));
        const osg::ref_ptr<const BrickModel> expected = legolizeOnCpu(*_transform, _lego->getSettings());
        EXPECT_EQ(selectVisible(*_lego->getBricks()), selectVisible(*expected)) << height;
    }
}

TEST_F(DraftFramesTest, BricksThatAProgramAsksForAreNoDraft)
{
    drawFrame();
    _lego->setSettings(parseSettings("20,parts=bricks,device=cpu"));
    drawFrame();
    EXPECT_EQ(_lego->getBricks()->getParts(), legolizeOnCpu(*_transform, _lego->getSettings())->getParts());
}

TEST_F(DraftFramesTest, TheFirstFrameShowsADraftIfTheSettingsSaySo)
{
    _lego->setSettings(parseSettings(std::string(LAID_LONG) + ",meanwhile=draft"));
    EXPECT_GT(countDrawn(*drawFrame()), 3000u);
    EXPECT_FALSE(_lego->isLegolized(_contextID));
    ASSERT_TRUE(_lego->getShownBricks());
    EXPECT_EQ(_lego->getShownBricks()->getParts(), legolizeOnCpu(*_transform, parseSettings(LAID_AT_ONCE))->getParts());
}

TEST_F(DraftFramesTest, AFrameThatWaitsShowsNoDraft)
{
    _lego->setWaiting(true);
    _lego->setSettings(parseSettings("20,parts=bricks,device=cpu,meanwhile=draft"));
    drawFrame();
    EXPECT_TRUE(_lego->isLegolized(_contextID));
    EXPECT_EQ(countShown(), 1u);
    _transform->setMatrix(osg::Matrix::scale(1.0, 1.0, 0.5));
    drawFrame();
    EXPECT_TRUE(_lego->isLegolized(_contextID));
    EXPECT_EQ(countShown(), 2u);
}

TEST_F(DraftFramesTest, ADraftIsShownWhenTheLimitOfAWaitIsOver)
{
    _lego->setSettings(parseSettings(LAID_LONG));
    _lego->setWaiting(true);
    _lego->setWaitingLimit(0.0);
    while (!_lego->getShownBricks())
        _viewer.frame();
    EXPECT_FALSE(_lego->isLegolized(_contextID));
    EXPECT_EQ(_lego->getShownBricks()->getParts(), legolizeOnCpu(*_transform, parseSettings(LAID_AT_ONCE))->getParts());
}

} // namespace

} // namespace osgLego::test
