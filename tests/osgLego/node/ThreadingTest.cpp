#include <common/RacingCar.h>

#include <GlTest.h>
#include <Meshes.h>

#include <tuple>

#include <osg/MatrixTransform>
#include <osgViewer/CompositeViewer>

namespace osgLego::test
{

namespace
{

/** Two contexts with one view each, and a scene in which a node has two parents and its source moves. */
class Threading : public GlTest,
                  public ::testing::WithParamInterface<std::tuple<osgViewer::ViewerBase::ThreadingModel, const char*>>
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
        _viewer.setThreadingModel(std::get<0>(GetParam()));
        _viewer.realize();
    }

    static LegoSettings parseSettings(const std::string& text)
    {
        return GlTest::parseSettings(text + ",device=" + std::get<1>(GetParam()));
    }

    void addView()
    {
        _contexts.push_back(createContext(static_cast<int>(_contexts.size() % 2)));
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        osg::Camera* camera = view->getCamera();
        camera->setGraphicsContext(_contexts.back());
        camera->setViewport(0, 0, WIDTH, HEIGHT);
        camera->setDrawBuffer(GL_BACK);
        camera->setReadBuffer(GL_BACK);
        camera->setClearColor(osg::Vec4(0.0f, 0.0f, 0.2f, 1.0f));
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

    /** Expect that, after a few more frames, every view shows the bricks of the current source. */
    void expectBricksInAllViews()
    {
        _lego->setWaiting(true);
        drawFrames(3);
        _viewer.stopThreading();
        for (unsigned int index = 0; index < _contexts.size(); ++index)
        {
            EXPECT_TRUE(_lego->isLegolized(_contexts[index]->getState()->getContextID()));
            expectPictureOfCpu(*_contexts[index], *_root, *_viewer.getView(index)->getCamera());
        }
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
    for (int frame = 0; frame < 20; ++frame)
    {
        _source->setMatrix(osg::Matrix::scale(1.0, 1.0, 1.0 + 0.02 * frame));
        _viewer.frame();
    }
    expectBricksInAllViews();
}

TEST_P(Threading, SettingsMayChangeWhileItRuns)
{
    for (int frame = 0; frame < 12; ++frame)
    {
        const char* texts[] = {"8", "12,proportions=plate", "10,method=points,fbo=64",
                               "14,method=points,target=addressed"};
        _lego->setSettings(parseSettings(texts[frame % 4]));
        _viewer.frame();
    }
    _lego->setSettings(parseSettings("12"));
    expectBricksInAllViews();
}

TEST_P(Threading, ProgressMayChangeWhileItRuns)
{
    for (int frame = 0; frame < 22; ++frame)
    {
        if (frame % 4 == 0) _source->setMatrix(osg::Matrix::scale(1.0, 1.0, 1.0 + 0.02 * frame));
        _lego->setBuildProgress(0.1 * (frame % 11));
        _lego->setNumNewParts(frame % 3 == 0 ? 5 : 0);
        _viewer.frame();
    }
    _lego->setBuildProgress(1.0);
    _lego->setNumNewParts(0);
    expectBricksInAllViews();
}

TEST_P(Threading, PassesThatAreStillDrawnBringNoBricksBackWhenTheSourceHasGone)
{
    for (int repeat = 0; repeat < 12; ++repeat)
    {
        _source->setMatrix(osg::Matrix::scale(1.0, 1.0, 1.0 + 0.02 * repeat));
        _viewer.frame();
        _lego->removeChild(_source);
        drawFrames(2);
        EXPECT_FALSE(_lego->getBound().valid()) << repeat;
        _lego->addChild(_source);
    }
    expectBricksInAllViews();
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
    expectBricksInAllViews();
}

TEST_P(Threading, NodesWhoseSplatsAreDrawnTogetherMayMoveComeAndGo)
{
    constexpr unsigned int NUM_GUESTS = 4;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> places;
    for (unsigned int index = 0; index < NUM_GUESTS; ++index)
    {
        const osg::ref_ptr<LegoNode> guest = new LegoNode(parseSettings("12,drawing=splats"));
        guest->addChild(createSphere(10));
        places.push_back(new osg::MatrixTransform);
        places.back()->addChild(guest);
        _root->addChild(places.back());
    }
    _lego->setSettings(parseSettings("12,drawing=splats"));
    for (unsigned int frame = 0; frame < 24; ++frame)
    {
        for (unsigned int index = 0; index < NUM_GUESTS; ++index)
            places[index]->setMatrix(
                osg::Matrix::translate(2.2 * index - 3.3, 0.02 * index * frame, 2.4 - 0.004 * frame));
        if (frame % 6 == 2) _root->removeChild(places[frame / 6]);
        if (frame % 6 == 5) _root->addChild(places[frame / 6]);
        _viewer.frame();
    }
    expectBricksInAllViews();
}

TEST_P(Threading, AViewMayBeAddedAndThreadsRestarted)
{
    drawFrames(3);
    _viewer.stopThreading();
    addView();
    _viewer.realize();
    _viewer.startThreading();
    expectBricksInAllViews();
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
    expectBricksInAllViews();
}

std::string nameOf(osgViewer::ViewerBase::ThreadingModel model)
{
    switch (model)
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
}

INSTANTIATE_TEST_SUITE_P(
    Models, Threading,
    ::testing::Combine(::testing::Values(osgViewer::ViewerBase::SingleThreaded,
                                         osgViewer::ViewerBase::CullDrawThreadPerContext,
                                         osgViewer::ViewerBase::DrawThreadPerContext,
                                         osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext),
                       ::testing::Values("gpu", "auto")),
    [](const auto& instance) { return nameOf(std::get<0>(instance.param)) + "_" + std::get<1>(instance.param); });

} // namespace

} // namespace osgLego::test
