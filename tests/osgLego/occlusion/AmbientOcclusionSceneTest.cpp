#include "AmbientOcclusionTest.h"

#include <algorithm>
#include <vector>

#include <osg/BlendFunc>
#include <osg/Texture2D>

namespace osgLego::test
{

namespace
{

using AmbientOcclusionSceneTest = AmbientOcclusionTest;

const osg::Vec4 GREEN(0.0f, 1.0f, 0.0f, 1.0f);

TEST_F(AmbientOcclusionSceneTest, ItIsComputedWhereverChildrenAreDrawn)
{
    const osg::ref_ptr<osg::Group> children = createMixedScene();
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", children);
    for (const Viewpoint& viewpoint :
         {MIXED_VIEW, Viewpoint{{120, -180, 140}, {4, 4, 1}}, Viewpoint{{6, 2, 3}, {4, 4, 1}}})
    {
        children->setCullingActive(true);
        const osg::ref_ptr<osg::Image> within = draw(*group, viewpoint);
        // Without culling, children may cover any part of the picture.
        for (unsigned int child = 0; child < children->getNumChildren(); ++child)
            children->getChild(child)->setCullingActive(false);
        const osg::ref_ptr<osg::Image> everywhere = draw(*group, viewpoint);
        for (unsigned int child = 0; child < children->getNumChildren(); ++child)
            children->getChild(child)->setCullingActive(true);
        EXPECT_EQ(countDifferent(*within, *everywhere, 0), 0u) << viewpoint.eye.x();
        EXPECT_GT(countDrawn(*within), 20u) << viewpoint.eye.x();
    }
}

/** Bounds that are smaller than the drawable, as of one that a vertex shader moves. */
struct SmallBounds : public osg::Drawable::ComputeBoundingBoxCallback
{
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return {0.0f, 0.0f, 0.0f, 0.1f, 0.1f, 0.1f}; }
};

TEST_F(AmbientOcclusionSceneTest, ChildrenExemptFromCullingAreDrawnBeyondTheirBounds)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    const osg::ref_ptr<osg::Geometry> quad = createQuad({0, 0, 0}, {4, 0, 0}, {0, 0, 4}, GREEN);
    quad->setComputeBoundingBoxCallback(new SmallBounds);
    geode->addDrawable(quad);
    geode->setCullingActive(false);
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", geode);
    const Pair pair = drawBoth(*group, *group, {{2, -15, 2}, {2, 0, 2}});
    EXPECT_GT(countDrawn(*pair.without), 1000u);
    EXPECT_EQ(countDrawn(*pair.with), countDrawn(*pair.without));
}

TEST_F(AmbientOcclusionSceneTest, NodesOutsideIntersectThoseInside)
{
    const auto countCover = [](const osg::Image& image, std::vector<bool>& cover)
    {
        cover.clear();
        for (int row = 0; row < HEIGHT; ++row)
            for (int column = 0; column < WIDTH; ++column)
                cover.push_back(readColor(image, column, row) == osg::Vec3d(0, 1, 0));
        return std::count(cover.begin(), cover.end(), true);
    };
    osg::ref_ptr<osg::Group> outside = new osg::Group;
    outside->addChild(createBall({2, 2, 2}, 1.5f, GREEN));                       // half in
    outside->addChild(createQuad({-2, 9, -1}, {12, 0, 0}, {0, 0, 5}, GREEN));    // behind
    outside->addChild(createQuad({6, -3, 1}, {2, 0, 0}, {0, 0, 2}, GREEN));      // in front
    outside->addChild(createQuad({-3, -1, 1.5f}, {4, 0, 0}, {0, 14, 1}, GREEN)); // through
    switchLighting(*outside, false);
    for (const bool groupIsFirst : {true, false})
        for (const double height : {0.0, 16.0})
        {
            const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("low", createMixedScene());
            osg::ref_ptr<osg::Group> root = new osg::Group;
            root->addChild(groupIsFirst ? group.get() : outside.get());
            root->addChild(groupIsFirst ? outside.get() : group.get());
            Viewpoint viewpoint = MIXED_VIEW;
            viewpoint.height = height;
            const Pair pair = drawBoth(*root, *group, viewpoint);
            std::vector<bool> with;
            std::vector<bool> without;
            const auto all = countCover(*pair.with, with);
            EXPECT_GT(all, 1000);
            EXPECT_NEAR(static_cast<double>(countCover(*pair.without, without)), static_cast<double>(all), 30.0);
            std::size_t different = 0;
            for (std::size_t index = 0; index < with.size(); ++index)
                different += with[index] != without[index] ? 1 : 0;
            EXPECT_LE(different, FEW_PIXELS) << groupIsFirst << " " << height;
            root->removeChild(outside);
            EXPECT_EQ(countCover(*draw(*root, viewpoint), with), 0);
        }
}

TEST_F(AmbientOcclusionSceneTest, OrdinaryChildrenWithNothingNearKeepTheirColours)
{
    osg::ref_ptr<osg::Group> children = new osg::Group;
    children->addChild(createQuad({0, 0, 0}, {3, 0, 0}, {0, 0, 3}, osg::Vec4(0.9f, 0.5f, 0.1f, 1.0f)));
    osg::ref_ptr<osg::Geometry> unlit = createQuad({4, 0, 0}, {3, 0, 0}, {0, 0, 3}, osg::Vec4(0.2f, 0.5f, 0.7f, 1.0f));
    switchLighting(*unlit, false);
    children->addChild(unlit);
    osg::ref_ptr<osg::Geometry> textured = createQuad({0, 0, 4}, {3, 0, 0}, {0, 0, 3}, WHITE);
    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(2, 2, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (unsigned int byte = 0; byte < 12; ++byte)
        picture->data()[byte] = static_cast<unsigned char>(20 * byte);
    textured->getOrCreateStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D(picture));
    children->addChild(textured);
    children->addChild(createQuad({4, 0, 4}, {3, 0, 2}, {0, 2, 3}, osg::Vec4(0.4f, 0.9f, 0.4f, 1.0f)));
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium,radius=0.5", children);
    const Pair pair = drawBoth(*group, *group, {{3.5, -15, 3.5}, {3.5, 0, 3.5}});
    EXPECT_GT(countDrawn(*pair.with), 5000u);
    EXPECT_EQ(countDrawn(*pair.with), countDrawn(*pair.without)) << "the background is as it was";
    EXPECT_LE(countDifferent(*pair.with, *pair.without, 6), FEW_PIXELS);
    EXPECT_LT(meanDifference(*pair.with, *pair.without), 1.0);
}

TEST_F(AmbientOcclusionSceneTest, ColoursOfBricksWithoutLightingAreShownAsTheyAre)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("low", createBrickBox({8, 8, 2}, "8"));
    switchLighting(*group, false);
    const Pair pair = drawBoth(*group, *group, MIXED_VIEW);
    EXPECT_GT(countDrawn(*pair.with), 3000u);
    EXPECT_LE(countDifferent(*pair.with, *pair.without, 1), FEW_PIXELS);
}

TEST_F(AmbientOcclusionSceneTest, SwitchedOffItIsAPlainGroup)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    osg::ref_ptr<osg::Group> plain = new osg::Group;
    plain->addChild(scene);
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("high", scene);
    group->setEnabled(false);
    const osg::ref_ptr<osg::Image> off = draw(*group, MIXED_VIEW);
    EXPECT_EQ(countDifferent(*off, *draw(*plain, MIXED_VIEW), 0), 0u);
    group->setEnabled(true);
    EXPECT_GT(countDifferent(*off, *draw(*group, MIXED_VIEW), 6), 300u) << "switched on it does something";
    group->setEnabled(false);
    EXPECT_EQ(countDifferent(*off, *draw(*group, MIXED_VIEW), 0), 0u);
}

TEST_F(AmbientOcclusionSceneTest, TransparentChildrenAreBlendedOverTheOccludedOnes)
{
    osg::ref_ptr<osg::Group> children = new osg::Group;
    children->addChild(createMixedScene());
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", children);
    const osg::ref_ptr<osg::Image> behind = draw(*group, MIXED_VIEW);
    osg::ref_ptr<osg::Geometry> glass =
        createQuad({1, -1, -1}, {6, 0, 0}, {0, 0, 4}, osg::Vec4(0.1f, 0.9f, 0.1f, 0.5f));
    switchLighting(*glass, false);
    glass->getStateSet()->setAttributeAndModes(new osg::BlendFunc);
    glass->getStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    // Culled first, it is drawn last.
    children->insertChild(0, glass);
    const osg::ref_ptr<osg::Image> both = draw(*group, MIXED_VIEW);
    for (const osg::Vec3d& place : {osg::Vec3d(2, -1, 0), osg::Vec3d(5, -1, 1), osg::Vec3d(4, -1, 1.5)})
    {
        const osg::Vec3d expected = colorAt(*behind, place) * 0.5 + osg::Vec3d(0.05, 0.45, 0.05);
        EXPECT_LT((colorAt(*both, place) - expected).length(), 0.02);
        EXPECT_GT((colorAt(*both, place) - colorAt(*behind, place)).length(), 0.05);
    }
}

TEST_F(AmbientOcclusionSceneTest, AGroupWithinAGroupIsAsOne)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    const osg::ref_ptr<AmbientOcclusionScene> outer = createGroup("medium", createGroup("low", scene));
    EXPECT_EQ(countDifferent(*draw(*createGroup("medium", scene), MIXED_VIEW), *draw(*outer, MIXED_VIEW), 0), 0u);
}

TEST_F(AmbientOcclusionSceneTest, BadSettingsAreRefused)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("high", nullptr);
    AmbientOcclusionSettings settings;
    settings.radius = -1.0;
    EXPECT_FALSE(group->setSettings(settings));
    EXPECT_EQ(group->getSettings().toString(), "high");
}

TEST_F(AmbientOcclusionSceneTest, TimesAreThereWhenTheyAreAskedFor)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("low", createMixedScene());
    const unsigned int contextID = _context->getState()->getContextID();
    draw(*group, MIXED_VIEW);
    EXPECT_EQ(group->getTimes(contextID).occlusion, 0.0);
    group->setTiming(true);
    draw(*group, MIXED_VIEW);
    const AmbientOcclusionTimes times = group->getTimes(contextID);
    for (const double time : {times.geometry, times.resolve, times.occlusion, times.denoise, times.composite})
        EXPECT_GT(time, 0.0);
}

TEST_F(AmbientOcclusionSceneTest, AnEmptyGroupDrawsNothing)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("low", nullptr);
    EXPECT_EQ(countDrawn(*draw(*group, MIXED_VIEW)), 0u);
}

TEST_F(AmbientOcclusionSceneTest, ReleasedObjectsComeBack)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const osg::ref_ptr<osg::Image> before = draw(*group, MIXED_VIEW);
    for (int repeat = 0; repeat < 3; ++repeat)
    {
        _context->makeCurrent();
        group->releaseGLObjects(repeat == 1 ? nullptr : _context->getState());
        EXPECT_EQ(countDifferent(*before, *draw(*group, MIXED_VIEW), 0), 0u);
        draw(*group, MIXED_VIEW);
    }
}

} // namespace

} // namespace osgLego::test
