#include <GlTest.h>
#include <Meshes.h>

#include <functional>
#include <utility>
#include <vector>

#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/NodeCallback>

namespace osgLego::test
{

namespace
{

/** Changes a scene in its next update, once. */
class ChangeOnce : public osg::NodeCallback
{
public:
    explicit ChangeOnce(std::function<void()> change) : _change(std::move(change)) {}

    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override
    {
        if (_change) std::exchange(_change, nullptr)();
        traverse(node, visitor);
    }

private:
    std::function<void()> _change;
};

/** A viewer that draws only while something needs it. */
class OnDemandTest : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _context = createContext();
        _transform->addChild(createSphere(12));
        _lego->addChild(_transform);
        _root->addChild(_lego);
        setUpViewer(_viewer, *_context, *_root);
    }

    /** Draw until the viewer would sleep. */
    osg::ref_ptr<osg::Image> drawUntilAsleep() { return drawUntilAsleep(_viewer, *_context); }

    bool isLegolized() const { return _lego->isLegolized(_context->getState()->getContextID()); }

    /** A picture of the present scene in a viewer of its own. */
    osg::ref_ptr<osg::Image> drawCopy() const
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        const osg::ref_ptr<LegoNode> copy = new LegoNode(*_lego, osg::CopyOp::DEEP_COPY_ALL);
        copy->setWaiting(true);
        const osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(copy);
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *root);
        viewer.getCamera()->setViewMatrix(_viewer.getCamera()->getViewMatrix());
        return drawUntilAsleep(viewer, *context);
    }

    osg::ref_ptr<osg::GraphicsContext> _context;
    osg::ref_ptr<osg::MatrixTransform> _transform = new osg::MatrixTransform;
    osg::ref_ptr<LegoNode> _lego = new LegoNode(parseSettings("16,device=cpu"));
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    osgViewer::Viewer _viewer;

private:
    static osg::ref_ptr<osg::Image> drawUntilAsleep(osgViewer::Viewer& viewer, osg::GraphicsContext& context)
    {
        constexpr int MANY = 100'000;
        int count = 0;
        context.makeCurrent(); // as the viewer left it, before drawCopy()
        for (; count == 0 || (viewer.checkNeedToDoFrame() && count < MANY); ++count)
            viewer.frame();
        EXPECT_LT(count, MANY);
        return readPixels(context);
    }
};

TEST_F(OnDemandTest, AViewerSleepsWhenItShowsTheBricks)
{
    for (const char* settings :
         {"16,device=cpu", "14,device=cpu,meanwhile=source", "16,device=gpu",
          "16,device=cpu,parts=bricks,meanwhile=nothing", "16,device=cpu,parts=bricks,progress=0.5"})
    {
        ASSERT_TRUE(_lego->setSettings(parseSettings(settings)));
        const osg::ref_ptr<osg::Image> shown = drawUntilAsleep();
        EXPECT_TRUE(isLegolized()) << settings;
        EXPECT_EQ(countDifferent(*shown, *drawCopy(), 0), 0u) << settings;
    }
}

TEST_F(OnDemandTest, EachChangeOfTheNodeWakesTheViewer)
{
    _lego->setSettings(parseSettings("16,device=cpu,parts=bricks"));
    drawUntilAsleep();
    BrickAppearance appearance;
    appearance.joints = false;
    const osg::ref_ptr<LightProbe> probe = new LightProbe;
    probe->setIntensity(0.5);
    const osg::ref_ptr<const BrickModel> stored = _lego->getBricks();
    const std::vector<std::function<void()>> changes = {
        [&] { _lego->setSettings(parseSettings("12,device=cpu,parts=bricks")); },
        [&] { _lego->setAppearance(appearance); },
        [&] { _lego->setLightProbe(probe); },
        [&] { _lego->setBuildProgress(0.5); },
        [&] { _lego->setNumNewParts(10); },
        [&] { _lego->setBuildProgress(1.0); },
        [&] { _lego->setStoredBricks(stored); }, // of 16 cells
        [&] { _lego->setStoredBricks(nullptr); },
    };
    osg::ref_ptr<osg::Image> before = readPixels(*_context);
    for (std::size_t index = 0; index < changes.size(); ++index)
    {
        changes[index]();
        EXPECT_TRUE(_viewer.checkNeedToDoFrame()) << "change " << index;
        const osg::ref_ptr<osg::Image> shown = drawUntilAsleep();
        EXPECT_GT(countDifferent(*shown, *before, 0), 0u) << "change " << index;
        before = shown;
    }
    _lego->dirty();
    EXPECT_TRUE(_viewer.checkNeedToDoFrame());
}

TEST_F(OnDemandTest, AChangedSourceIsShownWithoutAnotherRequest)
{
    drawUntilAsleep();
    _transform->setMatrix(osg::Matrix::scale(0.5, 1.0, 1.0));
    EXPECT_FALSE(_viewer.checkNeedToDoFrame()) << "the program requests the frame";
    const osg::ref_ptr<osg::Image> shown = drawUntilAsleep();
    EXPECT_TRUE(isLegolized());
    EXPECT_EQ(countDifferent(*shown, *drawCopy(), 0), 0u);
}

TEST_F(OnDemandTest, ChangesInQuickSuccessionEndWithTheirOwnOcclusion)
{
    BrickAppearance appearance;
    appearance.occlusion = BrickOcclusion::GRID;
    _lego->setAppearance(appearance);
    drawUntilAsleep();
    for (const double width : {0.3, 0.8, 0.5})
    {
        _transform->setMatrix(osg::Matrix::scale(width, 1.0, 1.0));
        _viewer.frame();
        _viewer.frame();
    }
    const osg::ref_ptr<osg::Image> shown = drawUntilAsleep();
    EXPECT_EQ(countDifferent(*shown, *drawCopy(), 0), 0u);
}

TEST_F(OnDemandTest, AChangeByTheUpdateOfAnotherNodeIsShownInItsFrame)
{
    _lego->setWaiting(true);
    drawUntilAsleep();
    _root->setUpdateCallback(new ChangeOnce([&] { _transform->setMatrix(osg::Matrix::scale(0.5, 1.0, 1.0)); }));
    _viewer.frame();
    EXPECT_TRUE(isLegolized());
    EXPECT_EQ(countDifferent(*readPixels(*_context), *drawCopy(), 0), 0u);
}

TEST_F(OnDemandTest, AParentCountsOnlyNodesAtWork)
{
    const osg::ref_ptr<LegoNode> other = new LegoNode(parseSettings("8,device=cpu"));
    other->addChild(createSphere(6));
    _root->addChild(other);
    EXPECT_EQ(_root->getNumChildrenRequiringUpdateTraversal(), 2u);
    drawUntilAsleep();
    EXPECT_EQ(_root->getNumChildrenRequiringUpdateTraversal(), 0u);
    _lego->dirty();
    EXPECT_EQ(_root->getNumChildrenRequiringUpdateTraversal(), 1u);
    _root->removeChild(_lego);
    EXPECT_EQ(_root->getNumChildrenRequiringUpdateTraversal(), 0u);
}

TEST_F(OnDemandTest, AFrozenNodeKeepsItsBricksUntilItsSettingsChange)
{
    const osg::ref_ptr<osg::Image> before = drawUntilAsleep();
    _lego->setUpdateMode(LegoNode::UpdateMode::FROZEN);
    drawUntilAsleep();
    _transform->setMatrix(osg::Matrix::scale(0.5, 1.0, 1.0));
    EXPECT_EQ(countDifferent(*drawUntilAsleep(), *before, 0), 0u);
    const osg::ref_ptr<LegoNode> copy = osg::clone(_lego.get());
    EXPECT_EQ(copy->getUpdateMode(), LegoNode::UpdateMode::FROZEN);
    _lego->setSettings(parseSettings("12,device=cpu"));
    drawUntilAsleep();
    EXPECT_TRUE(isLegolized());
    EXPECT_EQ(_lego->getShownBricks()->getGrid().dimensions, _lego->getBricks()->getGrid().dimensions);
    EXPECT_LT(_lego->getShownBricks()->getGrid().dimensions.x, 12) << "of the current source";
}

TEST_F(OnDemandTest, AnUnannouncedChangeIsFollowedIfEveryFrameIsRemade)
{
    const osg::ref_ptr<osg::Geometry> triangle = createTriangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1});
    _transform->removeChildren(0, 1);
    _transform->addChild(triangle);
    _lego->setWaiting(true);
    _viewer.frame();
    const std::size_t before = _lego->getShownBricks()->getBricks().size();
    (*static_cast<osg::Vec3Array*>(triangle->getVertexArray()))[2].set(1.0f, 0.0f, -0.9f);
    _viewer.frame();
    EXPECT_EQ(_lego->getShownBricks()->getBricks().size(), before) << "not detected";
    _lego->setUpdateMode(LegoNode::UpdateMode::EVERY_FRAME);
    EXPECT_TRUE(_viewer.checkNeedToDoFrame());
    _viewer.frame();
    EXPECT_LT(_lego->getShownBricks()->getBricks().size(), before);
    EXPECT_TRUE(_viewer.checkNeedToDoFrame());
}

} // namespace

} // namespace osgLego::test
