#include <common/RacingCar.h>

#include <GlTest.h>
#include <Meshes.h>

#include <osg/MatrixTransform>
#include <osgViewer/CompositeViewer>

namespace osgLego::test
{

namespace
{

/** Two contexts with one view each, and a scene in which a node has two parents and its source moves. */
class Threading : public GlTest, public ::testing::WithParamInterface<osgViewer::ViewerBase::ThreadingModel>
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _source = new osg::MatrixTransform;
        _source->addChild(createSphere(10));
        _lego = new LegoNode(parseSettings("12"));
        _lego->addChild(_source);
        _beside = new osg::MatrixTransform(osg::Matrix::translate(2.5, 0, 0));
        _beside->addChild(_lego);
        _root = new osg::Group;
        _root->addChild(_lego);
        _root->addChild(_beside);
        for (int index = 0; index < 2; ++index)
            addView();
        _viewer.setThreadingModel(GetParam());
        _viewer.realize();
    }

    void addView()
    {
        _contexts.push_back(createContext());
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        osg::Camera* camera = view->getCamera();
        camera->setGraphicsContext(_contexts.back());
        camera->setViewport(0, 0, WIDTH, HEIGHT);
        camera->setProjectionMatrixAsPerspective(30, static_cast<double>(WIDTH) / HEIGHT, 1, 100);
        camera->setViewMatrixAsLookAt(osg::Vec3d(0, -12, 3), osg::Vec3d(), osg::Vec3d(0, 0, 1));
        view->setSceneData(_root);
        _viewer.addView(view);
    }

    void drawFrames(int count)
    {
        for (int frame = 0; frame < count; ++frame)
            _viewer.frame();
    }

    void expectLegolized()
    {
        _viewer.stopThreading();
        for (const osg::ref_ptr<osg::GraphicsContext>& context : _contexts)
            EXPECT_TRUE(_lego->isLegolized(context->getState()->getContextID()));
    }

    std::vector<osg::ref_ptr<osg::GraphicsContext>> _contexts;
    osg::ref_ptr<osg::MatrixTransform> _source;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<osg::MatrixTransform> _beside;
    osg::ref_ptr<osg::Group> _root;
    osgViewer::CompositeViewer _viewer;
};

TEST_P(Threading, ASourceThatMovesInEveryFrameIsDrawnWithoutAHang)
{
    for (int frame = 0; frame < 40; ++frame)
    {
        _source->setMatrix(osg::Matrix::scale(1.0, 1.0, 1.0 + 0.02 * frame));
        _viewer.frame();
    }
    drawFrames(3);
    expectLegolized();
}

TEST_P(Threading, SettingsMayChangeWhileItRuns)
{
    for (int frame = 0; frame < 24; ++frame)
    {
        const char* texts[] = {"8", "12,proportions=plate", "10,method=points,fbo=64",
                               "14,method=points,target=addressed"};
        _lego->setSettings(parseSettings(texts[frame % 4]));
        _viewer.frame();
    }
    drawFrames(3);
    expectLegolized();
}

TEST_P(Threading, PassesThatAreStillDrawnBringNoBricksBackWhenTheSourceHasGone)
{
    for (int repeat = 0; repeat < 30; ++repeat)
    {
        _source->setMatrix(osg::Matrix::scale(1.0, 1.0, 1.0 + 0.02 * repeat));
        _viewer.frame();
        _lego->removeChild(_source);
        drawFrames(2);
        EXPECT_FALSE(_lego->getBound().valid()) << repeat;
        _lego->addChild(_source);
    }
    drawFrames(2);
    expectLegolized();
}

TEST_P(Threading, ANodeMayBeAddedAndRemovedWhileItRuns)
{
    for (int repeat = 0; repeat < 10; ++repeat)
    {
        osg::ref_ptr<LegoNode> guest = new LegoNode(parseSettings("10"));
        guest->addChild(createTriangle({-1, 0, 1}, {1, 0, 1}, {0, 1, 2}));
        _root->addChild(guest);
        drawFrames(repeat % 3);
        _root->removeChild(guest);
        guest = nullptr;
        drawFrames(1);
    }
    drawFrames(2);
    expectLegolized();
}

TEST_P(Threading, AViewMayBeAddedAndThreadsRestarted)
{
    drawFrames(3);
    _viewer.stopThreading();
    addView();
    _viewer.realize();
    _viewer.startThreading();
    drawFrames(4);
    expectLegolized();
}

TEST_P(Threading, GlObjectsMayBeReleasedBetweenFramesWhileNoThreadDraws)
{
    for (int repeat = 0; repeat < 8; ++repeat)
    {
        drawFrames(2);
        _viewer.stopThreading();
        _lego->releaseGLObjects();
        _viewer.startThreading();
    }
    drawFrames(3);
    expectLegolized();
}

INSTANTIATE_TEST_SUITE_P(Models, Threading,
                         ::testing::Values(osgViewer::ViewerBase::SingleThreaded,
                                           osgViewer::ViewerBase::CullDrawThreadPerContext,
                                           osgViewer::ViewerBase::DrawThreadPerContext,
                                           osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext),
                         [](const auto& instance)
                         {
                             switch (instance.param)
                             {
                             case osgViewer::ViewerBase::SingleThreaded:
                                 return "SingleThreaded";
                             case osgViewer::ViewerBase::CullDrawThreadPerContext:
                                 return "CullDrawThreadPerContext";
                             case osgViewer::ViewerBase::DrawThreadPerContext:
                                 return "DrawThreadPerContext";
                             default:
                                 return "CullThreadPerCameraDrawThreadPerContext";
                             }
                         });

} // namespace

} // namespace osgLego::test
