#include <osgLego/BrickScene.h>
#include <osgLego/LegoNode.h>

#include <GlTest.h>
#include <Meshes.h>
#include <Notices.h>
#include <OnDevices.h>

#include <osg/MatrixTransform>
#include <osg/Switch>
#include <osgUtil/LineSegmentIntersector>

namespace osgLego::test
{

namespace
{

/** A node below a transform, and a node above it, whose lattice therefore does not move. */
class NodePlaceTest : public OnDevices<GlTest>
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        _lego = new LegoNode(parseSettings("cell=0.2,anchor=world"));
        _lego->addChild(createSphere(12));
        _above->addChild(_lego);
        _root->addChild(_above);

        _reference = new LegoNode(parseSettings("cell=0.2"));
        _inside->addChild(createSphere(12));
        _reference->addChild(_inside);
        for (LegoNode* node : {_lego.get(), _reference.get()})
            node->setWaiting(true);
    }

    void move(const osg::Matrixd& matrix)
    {
        _above->setMatrix(matrix);
        _inside->setMatrix(matrix);
    }

    static osg::Matrixd stepAt(double time)
    {
        return osg::Matrixd::scale(1.0, 1.5, 0.7) * osg::Matrixd::rotate(time, osg::Vec3d(1, 2, 3)) *
               osg::Matrixd::translate(0.3 * time, 0.1 * time, 0.0);
    }

    osg::ref_ptr<LegoNode> _lego;
    osg::ref_ptr<osg::MatrixTransform> _above = new osg::MatrixTransform;
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    osg::ref_ptr<LegoNode> _reference;
    osg::ref_ptr<osg::MatrixTransform> _inside = new osg::MatrixTransform;
};

TEST_P(NodePlaceTest, AFigureThatWalksIsDrawnInALatticeThatStays)
{
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    const osg::ref_ptr<osg::Switch> both = new osg::Switch;
    both->addChild(_root);
    both->addChild(_reference);
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *both);
    const auto draw = [&](unsigned int child)
    {
        both->setSingleChildOn(child);
        viewer.frame();
        return readPixels(*context);
    };
    for (const double time : {0.0, 0.5, 1.0})
    {
        move(stepAt(time));
        const osg::ref_ptr<osg::Image> expected = draw(1);
        EXPECT_GT(countDrawn(*expected), 2000u);
        EXPECT_LT(countDifferent(*draw(0), *expected, 3), FEW_PIXELS) << time;
    }
}

TEST_P(NodePlaceTest, BricksBoundsAndIntersectionsAreThoseOfTheWorld)
{
    move(stepAt(0.7));
    EXPECT_EQ(_lego->getBricks()->getGrid(), _reference->getBricks()->getGrid());
    EXPECT_EQ(_lego->getBricks()->getBricks(), _reference->getBricks()->getBricks());
    EXPECT_TRUE(_root->getBound().contains(_reference->getBound().center()));
    EXPECT_GE(_root->getBound().radius(), 0.9f * _reference->getBound().radius());
    const auto pick = [](osg::Node& node)
    {
        osg::ref_ptr<osgUtil::LineSegmentIntersector> line =
            new osgUtil::LineSegmentIntersector(osg::Vec3d(5, 0.13, 0.17), osg::Vec3d(-5, 0.13, 0.17));
        osgUtil::IntersectionVisitor visitor(line);
        node.accept(visitor);
        return line->containsIntersections() ? line->getFirstIntersection().getWorldIntersectPoint() : osg::Vec3d();
    };
    EXPECT_GT(pick(*_reference).length(), 0.1);
    EXPECT_LT((pick(*_root) - pick(*_reference)).length(), 1e-5);
    const osg::ref_ptr<const osg::Node> exported = createBrickScene(*_root, BrickColors::BY_VERTEX);
    EXPECT_LT((pick(const_cast<osg::Node&>(*exported)) - pick(*_reference)).length(), 1e-5);
}

TEST_P(NodePlaceTest, TheResolutionCountsCellsOfTheModelInItsScene)
{
    _lego->setSettings(parseSettings("32,anchor=world"));
    _above->removeChild(_lego);
    ASSERT_TRUE(_lego->getBricks());
    const osg::ref_ptr<osg::MatrixTransform> smaller = new osg::MatrixTransform(osg::Matrixd::scale(1e-3, 1e-3, 1e-3));
    smaller->addChild(_lego);
    ASSERT_TRUE(_lego->getBricks());
    move(osg::Matrixd::scale(100, 100, 100)); // 3,200 of the first cells
    _above->addChild(_lego);
    smaller->removeChild(_lego);
    ASSERT_TRUE(_lego->getBricks()) << _lego->getObstacle();
    const BrickGrid grid = _lego->getBricks()->getGrid();
    EXPECT_NEAR(_above->getBound().radius() * 2.0 / grid.cellSize.x, 32 * std::sqrt(3.0), 4.0);
    _above->setMatrix(osg::Matrixd::scale(50, 50, 50));
    EXPECT_EQ(_lego->getBricks()->getGrid().cellSize, grid.cellSize)
        << "a model that moves in its scene keeps its cells";
}

TEST_P(NodePlaceTest, StoredBricksMoveWithTheNode)
{
    move(stepAt(0.7));
    EXPECT_FALSE(_lego->getBricksToNode().isIdentity());
    _lego->setStoredBricks(_reference->getBricks());
    EXPECT_TRUE(_lego->getBricksToNode().isIdentity());
}

TEST_P(NodePlaceTest, SeveralPlacesInTheWorldAreWarnedOfOnce)
{
    osg::ref_ptr<osg::MatrixTransform> second = new osg::MatrixTransform(osg::Matrixd::translate(5, 0, 0));
    second->addChild(_lego);
    _root->addChild(second);
    move(stepAt(0.7));
    const std::string notices = noticesOf([&] { _lego->getBricks(); });
    EXPECT_NE(notices.find("osgLego: a LegoNode has several places"), std::string::npos) << notices;
    EXPECT_EQ(_lego->getBricks()->getGrid(), _reference->getBricks()->getGrid()) << "the first place counts";
    EXPECT_EQ(noticesOf([&] { _lego->dirty(), _lego->getBricks(); }), "");
}

TEST_P(NodePlaceTest, ATransformWithoutAnInverseIsAnObstacle)
{
    _above->setMatrix(osg::Matrixd::scale(1, 1, 0));
    EXPECT_FALSE(_lego->getBricks());
    EXPECT_NE(_lego->getObstacle().find("no inverse"), std::string::npos) << _lego->getObstacle();
    _above->setMatrix(osg::Matrixd());
    EXPECT_TRUE(_lego->getBricks());
}

INSTANTIATE_ON_DEVICES(NodePlaceTest);

} // namespace

} // namespace osgLego::test
