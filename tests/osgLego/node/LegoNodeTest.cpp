#include <common/RacingCar.h>
#include <osgLego/LegoNode.h>

#include <GlDebug.h>
#include <GlTest.h>
#include <Meshes.h>
#include <Notices.h>
#include <OnDevices.h>

#include <osg/ContextData>
#include <osg/GLObjects>
#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>
#include <osg/Switch>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/Optimizer>
#include <osgViewer/CompositeViewer>

namespace osgLego::test
{

namespace
{

/** A sphere in a node of resolution 16, in a viewer. */
class LegoNodeTest : public OnDevices<GlTest>
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _context = createContext();
        _contextID = _context->getState()->getContextID();
        _source = new osg::Switch;
        _transform = new osg::MatrixTransform;
        _transform->addChild(createSphere(12));
        _source->addChild(_transform);
        _lego = new LegoNode(parseSettings("16"));
        _lego->setWaiting(true);
        _lego->addChild(_source);
        _root = new osg::Group;
        _root->addChild(_lego);
        setUpViewer(_viewer, *_context, *_root);
    }

    unsigned int countLegolizations() const { return _lego->getStatistics(_contextID).numLegolizations; }

    void expectPictureOfCpu() { GlTest::expectPictureOfCpu(*_context, *_root, *_viewer.getCamera()); }

    /** The number of legolizations in the frames after a change, which must show the bricks of the current source. */
    template <typename Change>
    unsigned int countAfter(const Change& change)
    {
        const unsigned int before = countLegolizations();
        change();
        for (int frame = 0; frame < 4; ++frame)
            _viewer.frame();
        EXPECT_TRUE(_lego->isLegolized(_contextID));
        expectPictureOfCpu();
        return countLegolizations() - before;
    }

    osg::ref_ptr<osg::GraphicsContext> _context;
    unsigned int _contextID = 0;
    osg::ref_ptr<osg::Switch> _source;
    osg::ref_ptr<osg::MatrixTransform> _transform;
    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<osg::Group> _root;
    osgViewer::Viewer _viewer;
};

/** Tests of the passes alone. */
class LegoNodePassesTest : public LegoNodeTest
{
};

TEST_P(LegoNodeTest, BricksAreMadeOnceAndNotInUnchangedFrames)
{
    EXPECT_EQ(countAfter([] {}), 1u);
    EXPECT_EQ(countAfter([] {}), 0u);
    for (int frame = 0; frame < 30; ++frame)
        _viewer.frame();
    EXPECT_EQ(countLegolizations(), 1u);
}

TEST_P(LegoNodeTest, TheFirstFrameShowsTheBricks)
{
    _viewer.frame();
    EXPECT_GT(countDrawn(*readPixels(*_context)), 3000u);
    EXPECT_EQ(_lego->getStatistics(_contextID).numDrawnBricks, _lego->getBricks()->getNumVisible());
}

TEST_P(LegoNodeTest, BricksAreMadeOnceForEachChange)
{
    _viewer.frame();
    EXPECT_EQ(countAfter([&] { _transform->setMatrix(osg::Matrix::scale(1, 2, 1)); }), 1u);
    EXPECT_EQ(countAfter([&] { _lego->setSettings(parseSettings("20,proportions=plate")); }), 1u);
    EXPECT_EQ(countAfter([&] { _lego->setSettings(parseSettings("20,proportions=plate")); }), 0u);
    EXPECT_EQ(countAfter([&] { _lego->addChild(createTorus()); }), 1u);
    EXPECT_EQ(countAfter([&] { _source->setAllChildrenOff(); }), 1u);
    EXPECT_EQ(countAfter([&] { _lego->dirty(); }), 1u);
    EXPECT_EQ(countAfter([&] { _lego->setReadBack(true); }), 1u);
}

TEST_P(LegoNodeTest, AnAnimatedSourceIsFollowedFrameByFrame)
{
    class Spin : public osg::NodeCallback
    {
    public:
        void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
        {
            _angle += 0.1;
            static_cast<osg::MatrixTransform*>(node)->setMatrix(osg::Matrix::rotate(_angle, osg::Vec3d(1, 1, 0)));
            traverse(node, visitor);
        }

    private:
        double _angle = 0.0;
    };
    _transform->setUpdateCallback(new Spin);
    for (int frame = 0; frame < 10; ++frame)
        _viewer.frame();
    EXPECT_EQ(countLegolizations(), 10u);
    _transform->setUpdateCallback(nullptr);
    EXPECT_EQ(countAfter([] {}), 0u);
}

TEST_P(LegoNodeTest, ADynamicGeometryIsFollowed)
{
    osg::ref_ptr<osg::Geometry> triangle = createTriangle({0, 0, 2}, {1, 0, 2}, {0, 1, 2});
    triangle->setDataVariance(osg::Object::DYNAMIC);
    _lego->addChild(triangle);
    _viewer.frame();
    auto& vertices = static_cast<osg::Vec3Array&>(*triangle->getVertexArray());
    EXPECT_EQ(countAfter([&] { vertices[0].z() = 3.0f; }), 1u);
    EXPECT_NEAR(_lego->getBricks()->getGrid().getBrickBounds().zMax(), 3.0, 0.3);
}

TEST_P(LegoNodeTest, BoundsAreThoseOfTheBricksIncludingStuds)
{
    const osg::BoundingBoxd bounds = _lego->getBricks()->getGrid().getBrickBounds();
    EXPECT_NEAR(bounds.zMax(), 1.0 + 0.2125 * 2.0 / 16.0, 1e-5);
    EXPECT_NEAR(_lego->getBound().radius(), bounds.radius(), 1e-5);
    EXPECT_NEAR((osg::Vec3d(_lego->getBound().center()) - bounds.center()).length(), 0.0, 1e-5);
    _transform->setMatrix(osg::Matrix::scale(3, 3, 3));
    EXPECT_NEAR(_lego->getBound().radius(), 3.0 * bounds.radius(), 1e-4) << "a change must take effect without a frame";
}

TEST_P(LegoNodeTest, BoundsFollowAChangeThatIsQueriedBeforeTheFrame)
{
    _viewer.frame();
    const float before = _root->getBound().radius();
    osg::Geometry& sphere = *_transform->getChild(0)->asGeode()->getDrawable(0)->asGeometry();
    auto& vertices = static_cast<osg::Vec3Array&>(*sphere.getVertexArray());
    for (osg::Vec3& vertex : vertices)
        vertex *= 2.0f;
    vertices.dirty();
    _lego->getBricks();
    _viewer.frame();
    EXPECT_NEAR(_root->getBound().radius(), 2.0f * before, 1e-3f);
}

TEST_P(LegoNodeTest, GlErrorsAreDetected)
{
    // Shows that these tests can fail.
    _context->makeCurrent();
    glEnable(GL_RGBA);
    EXPECT_FALSE(takeGlMessages().empty());
}

TEST_P(LegoNodeTest, GlErrorsOfAContextThatClosesAreDetected)
{
    class BadManager : public osg::GLObjectManager
    {
    public:
        explicit BadManager(unsigned int contextID) : osg::GLObjectManager("BadManager", contextID) {}
        void deleteGLObject(GLuint) override { glEnable(GL_RGBA); }
    };
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    osg::get<BadManager>(context->getState()->getContextID())->scheduleGLObjectForDeletion(1);
    context->close(true);
    EXPECT_FALSE(takeGlMessages().empty());
}

TEST_P(LegoNodeTest, TwoParentsShareOneLegolization)
{
    osg::ref_ptr<osg::MatrixTransform> second = new osg::MatrixTransform(osg::Matrix::translate(3, 0, 0));
    second->addChild(_lego);
    _root->addChild(second);
    EXPECT_EQ(countAfter([] {}), 1u);
    EXPECT_EQ(countAfter([&] { _lego->dirty(); }), 1u);
    const std::size_t both = countDrawn(*readPixels(*_context));
    _root->removeChild(second);
    _viewer.frame();
    EXPECT_GT(both, countDrawn(*readPixels(*_context)) + 500);
}

TEST_P(LegoNodeTest, TwoViewsOfOneContextShareOneLegolization)
{
    osgViewer::CompositeViewer viewer;
    for (int index = 0; index < 2; ++index)
    {
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        osg::Camera* camera = view->getCamera();
        camera->setGraphicsContext(_context);
        camera->setViewport(index * WIDTH / 2, 0, WIDTH / 2, HEIGHT);
        camera->setProjectionMatrixAsPerspective(30, 0.5 * WIDTH / HEIGHT, 1, 100);
        camera->setViewMatrixAsLookAt(osg::Vec3d(0, -9, 2), osg::Vec3d(), osg::Vec3d(0, 0, 1));
        view->setSceneData(_root);
        viewer.addView(view);
    }
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    viewer.setReleaseContextAtEndOfFrameHint(false);
    for (int frame = 0; frame < 4; ++frame)
        viewer.frame();
    EXPECT_EQ(countLegolizations(), 1u);
    _lego->dirty();
    for (int frame = 0; frame < 4; ++frame)
        viewer.frame();
    EXPECT_EQ(countLegolizations(), 2u);
}

TEST_P(LegoNodeTest, TwoContextsHaveBricksOfTheirOwn)
{
    const osg::ref_ptr<osg::GraphicsContext> other = createContext();
    osgViewer::Viewer otherViewer;
    setUpViewer(otherViewer, *other, *_root);
    _viewer.frame();
    otherViewer.frame();
    EXPECT_EQ(countLegolizations(), 1u);
    EXPECT_EQ(_lego->getStatistics(other->getState()->getContextID()).numLegolizations, 1u);
    EXPECT_EQ(countDifferent(*readPixels(*_context), *readPixels(*other), 0), 0u);
}

TEST_P(LegoNodeTest, AContextThatIsClosedAndReopenedGetsItsBricksBack)
{
    _viewer.frame();
    const osg::ref_ptr<osg::Image> before = readPixels(*_context);
    _viewer.getCamera()->setGraphicsContext(nullptr);
    _lego->releaseGLObjects(_context->getState());
    _context->close(true);
    _context = createContext();
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *_context, *_root);
    viewer.frame();
    EXPECT_EQ(countDifferent(*before, *readPixels(*_context), 0), 0u);
}

TEST_P(LegoNodeTest, EveryNewViewerGetsItsBricksInItsFirstFrame)
{
    _viewer.frame();
    const osg::ref_ptr<osg::Image> expected = readPixels(*_context);
    // Many viewers, since a new visitor only sometimes gets the address of a deleted one.
    for (int repeat = 0; repeat < 40; ++repeat)
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *_root);
        viewer.frame();
        ASSERT_TRUE(_lego->isLegolized(context->getState()->getContextID())) << repeat;
        ASSERT_EQ(countDifferent(*expected, *readPixels(*context), 0), 0u) << repeat;
    }
}

TEST_P(LegoNodeTest, WithoutTrianglesTheSourceIsDrawnAsItIs)
{
    osg::ref_ptr<osg::Geometry> lines = createTriangle({-1, 0, -1}, {1, 0, 1}, {1, 0, -1});
    lines->setPrimitiveSet(0, new osg::DrawArrays(GL_LINE_LOOP, 0, 3));
    _lego->removeChildren(0, _lego->getNumChildren());
    _lego->addChild(lines);
    EXPECT_FALSE(_lego->hasTriangles());
    EXPECT_FALSE(_lego->getBricks());
    _viewer.frame();
    const std::size_t drawn = countDrawn(*readPixels(*_context));
    EXPECT_GT(drawn, 50u);
    EXPECT_LT(drawn, 1000u);
}

TEST_P(LegoNodeTest, AnEmptyNodeDrawsNothing)
{
    _lego->removeChildren(0, _lego->getNumChildren());
    _viewer.frame();
    EXPECT_EQ(countDrawn(*readPixels(*_context)), 0u);
    EXPECT_FALSE(_lego->getBound().valid());
}

TEST_P(LegoNodeTest, BadSettingsAreRefused)
{
    LegoSettings settings;
    settings.grid.resolution = 0;
    EXPECT_FALSE(_lego->setSettings(settings));
    EXPECT_EQ(_lego->getSettings(), parseSettings("16"));
}

TEST_P(LegoNodeTest, TheOptimizerLeavesATransformAboveInPlace)
{
    osg::ref_ptr<osg::MatrixTransform> above = new osg::MatrixTransform(osg::Matrix::rotate(0.7, osg::Vec3d(1, 0, 0)));
    above->setDataVariance(osg::Object::STATIC);
    above->addChild(_lego);
    _root->removeChild(_lego);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(above);
    const osg::ref_ptr<const BrickModel> before = _lego->getBricks();
    osgUtil::Optimizer().optimize(root, osgUtil::Optimizer::DEFAULT_OPTIMIZATIONS);
    ASSERT_EQ(_lego->getNumParents(), 1u);
    EXPECT_EQ(_lego->getParent(0), above.get());
    EXPECT_NEAR(above->getMatrix()(1, 2), osg::Matrix::rotate(0.7, osg::Vec3d(1, 0, 0))(1, 2), 1e-9);
    EXPECT_EQ(_lego->getBricks()->getBricks(), before->getBricks());
}

TEST_P(LegoNodeTest, TheOptimizerDuplicatesANodeBelowStaticTransforms)
{
    _root->removeChild(_lego);
    for (const double x : {-1.5, 1.5})
    {
        osg::ref_ptr<osg::MatrixTransform> above = new osg::MatrixTransform(osg::Matrix::translate(x, 0.0, 0.0));
        above->setDataVariance(osg::Object::STATIC);
        above->addChild(_lego);
        _root->addChild(above);
    }
    _viewer.frame();
    const osg::ref_ptr<osg::Image> before = readPixels(*_context);
    const auto optimize = [&] {
        osgUtil::Optimizer().optimize(_root,
                                      osgUtil::Optimizer::FLATTEN_STATIC_TRANSFORMS_DUPLICATING_SHARED_SUBGRAPHS);
    };
    EXPECT_EQ(noticesOf(optimize), "");
    _viewer.frame();
    EXPECT_GT(countDrawn(*before), 3000u);
    EXPECT_LT(countDifferent(*before, *readPixels(*_context), 10), 20u);
}

TEST_P(LegoNodeTest, PickingHitsTheBricks)
{
    const auto pick = [&](const osg::Vec3d& from, const osg::Vec3d& to)
    {
        osg::ref_ptr<osgUtil::LineSegmentIntersector> intersector = new osgUtil::LineSegmentIntersector(from, to);
        osgUtil::IntersectionVisitor visitor(intersector);
        _root->accept(visitor);
        return intersector;
    };
    // The sphere touches x = 1 in a single point; its bricks have a flat side there.
    const auto hit = pick({5, 0.06, 0.06}, {-5, 0.06, 0.06});
    ASSERT_TRUE(hit->containsIntersections());
    EXPECT_NEAR(hit->getFirstIntersection().getWorldIntersectPoint().x(), 1.0, 1e-5);
    EXPECT_FALSE(pick({5, 1.2, 0}, {-5, 1.2, 0})->containsIntersections());
}

TEST_P(LegoNodeTest, ACloneHasItsOwnBricksOfTheSameSource)
{
    osg::ref_ptr<LegoNode> copy = osg::clone(_lego.get(), osg::CopyOp::SHALLOW_COPY);
    EXPECT_EQ(copy->getSettings(), _lego->getSettings());
    EXPECT_EQ(copy->getNumChildren(), 1u);
    EXPECT_EQ(copy->getBricks()->getBricks(), _lego->getBricks()->getBricks());
    _root->removeChild(_lego);
    _root->addChild(copy);
    _viewer.frame();
    EXPECT_TRUE(copy->isLegolized(_contextID));
}

TEST_P(LegoNodeTest, TheReadBackContainsTheWholeModel)
{
    _lego->setReadBack(true);
    _viewer.frame();
    const osg::ref_ptr<const BrickModel> cells = _lego->getBricks(_contextID);
    ASSERT_TRUE(cells);
    EXPECT_EQ(cells->getBricks().size(), _lego->getBricks()->getBricks().size());
    _lego->setReadBack(false);
    _viewer.frame();
    EXPECT_FALSE(_lego->getBricks(_contextID));
}

TEST_P(LegoNodePassesTest, TimesAreMeasuredOnRequest)
{
    _lego->setTiming(true);
    _viewer.frame();
    const LegoStatistics statistics = _lego->getStatistics(_contextID);
    EXPECT_GT(statistics.flattening, 0.0);
    EXPECT_GT(statistics.subdivision, 0.0);
    EXPECT_GT(statistics.voxelization, 0.0);
    EXPECT_GT(statistics.extraction, 0.0);
}

TEST_P(LegoNodeTest, PickingFollowsAChangeWithoutAnUpdate)
{
    const auto isHitAt = [&](double x)
    {
        osg::ref_ptr<osgUtil::LineSegmentIntersector> intersector =
            new osgUtil::LineSegmentIntersector(osg::Vec3d(x, -5.0, 0.06), osg::Vec3d(x, 5.0, 0.06));
        osgUtil::IntersectionVisitor visitor(intersector);
        _root->accept(visitor);
        return intersector->containsIntersections();
    };
    EXPECT_TRUE(isHitAt(0.06));
    _transform->setMatrix(osg::Matrix::translate(10.0, 0.0, 0.0));
    _lego->dirty();
    EXPECT_TRUE(isHitAt(10.06));
    EXPECT_FALSE(isHitAt(0.06));
}

TEST_P(LegoNodePassesTest, SubdivisionContinuesUntilTheCountIsStable)
{
    _lego->setSettings(parseSettings("16,edge=0.5"));
    _viewer.frame();
    const LegoStatistics statistics = _lego->getStatistics(_contextID);
    EXPECT_GE(statistics.numSubdivisionPasses, 3u);
    EXPECT_GT(statistics.numFineTriangles, statistics.numTriangles);
    _lego->setSettings(parseSettings("4,edge=4"));
    _viewer.frame();
    EXPECT_EQ(_lego->getStatistics(_contextID).numSubdivisionPasses, 0u);
    EXPECT_EQ(_lego->getStatistics(_contextID).numFineTriangles, statistics.numTriangles);
}

INSTANTIATE_ON_DEVICES(LegoNodeTest);
INSTANTIATE_TEST_SUITE_P(Device, LegoNodePassesTest, ::testing::Values("gpu"), nameOfDevice);

} // namespace

} // namespace osgLego::test
