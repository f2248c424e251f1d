#include <common/RacingCar.h>
#include <osgLego/LegoNode.h>

#include <GlTest.h>
#include <Meshes.h>

#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

/** A car in a viewer, whose bricks are found on the CPU or the GPU. */
class DeviceTest : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _context = createContext();
        _contextID = _context->getState()->getContextID();
        _lego->addChild(createRacingCar());
        _lego->setWaiting(true);
        setUpViewer(_viewer, *_context, *_lego);
    }

    LegoStatistics draw(const char* settings)
    {
        EXPECT_TRUE(_lego->setSettings(parseSettings(settings)));
        _viewer.frame();
        EXPECT_TRUE(_lego->isLegolized(_contextID)) << _lego->getFailure(_contextID);
        return _lego->getStatistics(_contextID);
    }

    osg::ref_ptr<osg::GraphicsContext> _context;
    unsigned int _contextID = 0;
    osg::ref_ptr<LegoNode> _lego = new LegoNode;
    osgViewer::Viewer _viewer;
};

TEST_F(DeviceTest, AutoUsesTheCpuOnASoftwareRenderer)
{
    // Before the first frame the renderer is unknown; test a later frame too.
    EXPECT_EQ(draw("24,device=auto").isFromCpu, isSoftware(*_context));
    const LegoStatistics again = draw("28,device=auto");
    EXPECT_EQ(again.isFromCpu, isSoftware(*_context));
    EXPECT_EQ(again.numLegolizations, 2u);
}

TEST_F(DeviceTest, AutoUsesTheGpuForThePapersMethods)
{
    EXPECT_FALSE(draw("16,method=points,device=auto").isFromCpu);
}

TEST_F(DeviceTest, BothDrawTheSamePicture)
{
    EXPECT_FALSE(draw("40,device=gpu").isFromCpu);
    const osg::ref_ptr<osg::Image> expected = readPixels(*_context);
    EXPECT_TRUE(draw("40,device=cpu").isFromCpu);
    const osg::ref_ptr<osg::Image> found = readPixels(*_context);
    EXPECT_GT(countDrawn(*found), 3000u);
    EXPECT_EQ(countDifferent(*expected, *found, 3), 0u);
}

TEST_F(DeviceTest, OnTheCpuBricksAreMadeAgainOnlyAfterAChange)
{
    EXPECT_EQ(draw("16,device=cpu").numLegolizations, 1u);
    for (int frame = 0; frame < 10; ++frame)
        _viewer.frame();
    EXPECT_EQ(_lego->getStatistics(_contextID).numLegolizations, 1u);
    _lego->dirty();
    _viewer.frame();
    EXPECT_EQ(_lego->getStatistics(_contextID).numLegolizations, 2u);
}

TEST_F(DeviceTest, OnTheCpuDrawingAndQueriesShareOneModel)
{
    _lego->setReadBack(true);
    const LegoStatistics statistics = draw("30,device=cpu");
    EXPECT_EQ(_lego->getBricks(_contextID), _lego->getBricks());
    EXPECT_EQ(statistics.numDrawnBricks, _lego->getBricks()->getNumVisible());
    EXPECT_EQ(statistics.numSubdivisionPasses, 0u);
}

TEST_F(DeviceTest, BricksMatchTheSettingsAfterChangingTheDeviceBackAndForth)
{
    for (const char* settings : {"20,device=cpu", "20,device=gpu", "33,device=cpu", "33,device=gpu", "20,device=auto"})
    {
        const LegoStatistics statistics = draw(settings);
        const auto expected = static_cast<double>(_lego->getBricks()->getNumVisible());
        // The GPU works in single precision: cells that a triangle merely grazes may differ.
        const double margin = statistics.isFromCpu ? 0.0 : 2.0;
        EXPECT_NEAR(static_cast<double>(statistics.numDrawnBricks), expected, margin) << settings;
    }
}

} // namespace

} // namespace osgLego::test
