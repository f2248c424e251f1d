#include <LookTest.h>

#include <functional>

#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/Camera>
#include <osg/ClearNode>
#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/MatrixTransform>
#include <osg/Texture2D>

namespace osgLego::test
{

namespace
{

const osg::Vec4 SKY_COLOR(0.0f, 1.0f, 0.0f, 1.0f);

/** Bricks in a group, and the effects of the outer state and of other children on them. */
class AmbientOcclusionState : public LookTest
{
protected:
    AmbientOcclusionState() : _view{{9, -14, 9}, {4, 3, 1}}, _children(new osg::Group)
    {
        _children->addChild(createBrickBox({8, 6, 3}, "8"));
        _group = createGroup("medium", _children);
    }

    osg::ref_ptr<osg::Image> drawGroup() { return draw(*_group, _view); }

    osg::ref_ptr<osg::Image> drawBelow(const std::function<void(osg::StateSet&)>& change)
    {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(_group);
        change(*root->getOrCreateStateSet());
        return draw(*root, _view);
    }

    /** An unlit quad behind or in front of the bricks. */
    static osg::ref_ptr<osg::Geometry> createSheet(double y, const osg::Vec4& color)
    {
        osg::ref_ptr<osg::Geometry> sheet =
            createQuad(osg::Vec3(-20, static_cast<float>(y), -20), {60, 0, 0}, {0, 0, 60}, color);
        sheet->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        return sheet;
    }

    Viewpoint _view;
    osg::ref_ptr<osg::Group> _children;
    osg::ref_ptr<AmbientOcclusionScene> _group;
};

TEST_F(AmbientOcclusionState, BlendingAndAlphaTestsAboveDoNotChangeTheBricks)
{
    const osg::ref_ptr<osg::Image> expected = drawGroup();
    EXPECT_LE(countDifferent(*expected,
                             *drawBelow([](osg::StateSet& state) { state.setAttributeAndModes(new osg::BlendFunc); }),
                             2),
              FEW_PIXELS);
    const auto testAlpha = [](osg::StateSet& state)
    { state.setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GREATER, 0.5f)); };
    EXPECT_LE(countDifferent(*expected, *drawBelow(testAlpha), 2), FEW_PIXELS);
}

TEST_F(AmbientOcclusionState, AColourMaskAboveMasksThePicture)
{
    const osg::ref_ptr<osg::Image> whole = drawGroup();
    const osg::ref_ptr<osg::Image> masked =
        drawBelow([](osg::StateSet& state) { state.setAttribute(new osg::ColorMask(false, true, true, true)); });
    const osg::Vec3d place(4, 0, 1.5);
    const osg::Vec3d expected = colorAt(*whole, place);
    const osg::Vec3d color = colorAt(*masked, place);
    EXPECT_NEAR(color.x(), 0.0, 0.01) << "the background has no red";
    EXPECT_NEAR(color.y(), expected.y(), 0.01);
    EXPECT_NEAR(color.z(), expected.z(), 0.01);
}

TEST_F(AmbientOcclusionState, ChildrenThatLeaveNoDepthAreSeen)
{
    const osg::Vec3d beside(-5, 8, 4);
    const osg::ref_ptr<osg::Geometry> sky = createSheet(20.0, SKY_COLOR);
    sky->getStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 1.0, 1.0));
    _children->addChild(sky);
    osg::ref_ptr<osg::Image> image = drawGroup();
    EXPECT_LT((colorAt(*image, beside) - osg::Vec3d(0, 1, 0)).length(), 0.02);
    EXPECT_GT((colorAt(*image, {4, 0, 1.5}) - osg::Vec3d(0, 1, 0)).length(), 0.2) << "the sky hides the bricks";

    sky->getStateSet()->removeAttribute(osg::StateAttribute::DEPTH);
    sky->getStateSet()->setMode(GL_DEPTH_TEST, osg::StateAttribute::OFF);
    sky->getStateSet()->setRenderBinDetails(-1, "RenderBin");
    image = drawGroup();
    EXPECT_LT((colorAt(*image, beside) - osg::Vec3d(0, 1, 0)).length(), 0.02);
}

TEST_F(AmbientOcclusionState, TransparencyWithinOtherBinsIsBlended)
{
    const osg::Vec3d place(4, 0, 1.5);
    const osg::Vec3d behind = colorAt(*drawGroup(), place);
    const osg::ref_ptr<osg::Geometry> glass = createSheet(-2.0, osg::Vec4(0.0f, 1.0f, 0.0f, 0.5f));
    glass->getStateSet()->setAttributeAndModes(new osg::BlendFunc);
    glass->getStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    osg::ref_ptr<osg::Group> bin = new osg::Group;
    bin->getOrCreateStateSet()->setRenderBinDetails(1, "RenderBin");
    bin->addChild(glass);
    _children->insertChild(0, bin);
    const osg::Vec3d expected = behind * 0.5 + osg::Vec3d(0.0, 0.5, 0.0);
    EXPECT_LT((colorAt(*drawGroup(), place) - expected).length(), 0.03);
}

TEST_F(AmbientOcclusionState, ACameraThatDrawsAfterTheFrameDoesSo)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setRenderOrder(osg::Camera::POST_RENDER);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    camera->setProjectionMatrixAsOrtho2D(-1, 1, -1, 1);
    camera->addChild(createQuad({-0.2f, -0.2f, 0}, {0.4f, 0, 0}, {0, 0.4f, 0}, SKY_COLOR));
    camera->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    _children->addChild(camera);
    const osg::Vec3d color = readColor(*drawGroup(), WIDTH / 2, HEIGHT / 2);
    EXPECT_LT((color - osg::Vec3d(0, 1, 0)).length(), 0.02);
}

TEST_F(AmbientOcclusionState, AClearNodeAmongTheChildrenGivesTheFrameItsBackground)
{
    const osg::Vec3d beside(-5, 8, 4);
    const osg::Vec3d bricks(4, 0, 1.5);
    const osg::Vec3d expected = colorAt(*drawGroup(), bricks);
    const osg::ref_ptr<osg::ClearNode> clear = new osg::ClearNode;
    clear->setClearColor(SKY_COLOR);
    _children->insertChild(0, clear);
    for (int frame = 0; frame < 2; ++frame)
    {
        const osg::ref_ptr<osg::Image> image = drawGroup();
        EXPECT_LT((colorAt(*image, beside) - osg::Vec3d(0, 1, 0)).length(), 0.02) << frame;
        EXPECT_LT((colorAt(*image, bricks) - expected).length(), 0.02) << frame;
    }
}

TEST_F(AmbientOcclusionState, AClearNodeAmongTheChildrenThatKeepsTheFrameLeavesNoTraceOfEarlierBricks)
{
    const osg::Vec3d place(4, 0, 1.5);
    const osg::ref_ptr<osg::ClearNode> keep = new osg::ClearNode;
    keep->setRequiresClear(false);
    _children->addChild(keep);
    drawGroup();
    _children->getChild(0)->setNodeMask(0);
    // This background, which is drawn before the scene, replaces the bricks of the last frame.
    osg::ref_ptr<osg::Group> root = new osg::Group;
    const osg::ref_ptr<osg::Geometry> sky = createSheet(20.0, SKY_COLOR);
    sky->getStateSet()->setRenderBinDetails(-1, "RenderBin");
    sky->getStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 1.0, 1.0));
    root->addChild(sky);
    root->addChild(_group);
    const osg::ref_ptr<osg::Image> image = draw(*root, _view);
    EXPECT_LT((colorAt(*image, place) - osg::Vec3d(0, 1, 0)).length(), 0.02);
}

TEST_F(AmbientOcclusionState, ACameraThatDrawsToATextureBetweenTheBricksLeavesTheirPicture)
{
    const auto createBox = [] { return createBrickBox({8, 6, 3}, "8"); };
    const osg::ref_ptr<osg::MatrixTransform> second = new osg::MatrixTransform(osg::Matrix::translate(0, 0, 3.6));
    second->addChild(createBrickBox({4, 3, 2}, "4", SKY_COLOR));
    _children->addChild(second);
    const osg::ref_ptr<osg::Image> expected = drawGroup();
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(64, 64);
    texture->setInternalFormat(GL_RGBA8);
    const osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setViewport(0, 0, 64, 64);
    camera->setClearColor(osg::Vec4(1.0f, 0.0f, 0.0f, 1.0f));
    camera->attach(osg::Camera::COLOR_BUFFER, texture);
    camera->setProjectionMatrixAsPerspective(30.0, 1.0, 0.1, 1000.0);
    camera->setViewMatrixAsLookAt({9, -14, 9}, {4, 3, 1}, {0, 0, 1});
    camera->addChild(createBox());
    _children->insertChild(1, camera);
    for (int frame = 0; frame < 2; ++frame)
        EXPECT_EQ(countDifferent(*drawGroup(), *expected, 0), 0u) << frame;
    // The bricks below the camera fill the middle of its texture.
    const osg::ref_ptr<osg::Image> target = new osg::Image;
    _context->makeCurrent();
    _context->getState()->applyTextureAttribute(0, texture);
    target->readImageFromCurrentTexture(_context->getState()->getContextID(), false);
    EXPECT_LT(
        (osg::Vec3d(target->getColor(1u, 62u).r(), target->getColor(1u, 62u).g(), 0.0) - osg::Vec3d(1, 0, 0)).length(),
        0.02);
    EXPECT_GT(target->getColor(32u, 32u).g(), 0.2f);
}

TEST_F(AmbientOcclusionState, FramesDrawnAgainUnderOneNumberAreTheSame)
{
    const osg::ref_ptr<osg::Image> first = drawGroup();
    for (int time = 0; time < 5; ++time)
        _viewer.renderingTraversals();
    EXPECT_EQ(countDifferent(*first, *readPixels(*_context), 0), 0u);
}

} // namespace

} // namespace osgLego::test
