#include <osgLego/data/DistantOcclusion.h>

#include <common/BrickRayCaster.h>
#include <common/RacingCar.h>

#include <GlDebug.h>
#include <LookTest.h>
#include <Meshes.h>
#include <Probes.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <glm/geometric.hpp>
#include <osg/BlendFunc>
#include <osg/Geode>
#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>
#include <osg/Texture2D>
#include <osgViewer/CompositeViewer>

namespace osgLego::test
{

namespace
{

const osg::Vec4 WHITE(1.0f, 1.0f, 1.0f, 1.0f);
const osg::Vec4 GREEN(0.0f, 1.0f, 0.0f, 1.0f);

void switchLighting(osg::Node& node, bool isOn)
{
    node.getOrCreateStateSet()->setMode(GL_LIGHTING, (isOn ? osg::StateAttribute::ON : osg::StateAttribute::OFF) |
                                                         osg::StateAttribute::PROTECTED);
}

/** A white floor and wall that meet at the x axis. */
osg::ref_ptr<osg::Group> createInnerEdge()
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createQuad({-10, -10, 0}, {20, 0, 0}, {0, 10, 0}, WHITE));
    group->addChild(createQuad({-10, 0, 0}, {20, 0, 0}, {0, 0, 10}, WHITE));
    return group;
}

osg::ref_ptr<osg::Geode> createBall(const osg::Vec3& center, float radius, const osg::Vec4& color)
{
    osg::ref_ptr<osg::ShapeDrawable> ball = new osg::ShapeDrawable(new osg::Sphere(center, radius));
    ball->setColor(color);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(ball);
    return geode;
}

/** A scene of bricks and other nodes: a ball on a box of 8 x 8 x 2. */
osg::ref_ptr<osg::Group> createMixedScene()
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createBrickBox({8, 8, 2}, "8", osg::Vec4(0.8f, 0.3f, 0.2f, 1.0f)));
    group->addChild(createBall({5, 3, 3}, 1.2f, osg::Vec4(0.3f, 0.6f, 0.9f, 1.0f)));
    return group;
}

const Viewpoint MIXED_VIEW{{12, -18, 14}, {4, 4, 1}};

class AmbientOcclusionSceneTest : public LookTest
{
protected:
    /** The picture of a scene below a camera that renders to a texture. */
    osg::ref_ptr<osg::Image> drawToTexture(osg::Node& scene, const Viewpoint& viewpoint, unsigned int samples,
                                           osg::Transform::ReferenceFrame frame = osg::Transform::ABSOLUTE_RF)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(WIDTH, HEIGHT, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        camera->setRenderOrder(osg::Camera::PRE_RENDER);
        camera->setReferenceFrame(frame);
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera->attach(osg::Camera::COLOR_BUFFER, image, samples, samples);
        camera->setViewport(0, 0, WIDTH, HEIGHT);
        camera->setClearColor(_viewer.getCamera()->getClearColor());
        if (frame == osg::Transform::ABSOLUTE_RF) viewpoint.apply(*camera);
        camera->addChild(&scene);
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(camera);
        draw(*root, viewpoint);
        return image;
    }

    /** A picture with and without a group around a node. */
    struct Pair
    {
        osg::ref_ptr<osg::Image> with;
        osg::ref_ptr<osg::Image> without;
    };

    Pair drawBoth(osg::Node& root, AmbientOcclusionScene& group, const Viewpoint& viewpoint)
    {
        Pair pair;
        group.setEnabled(true);
        pair.with = draw(root, viewpoint);
        group.setEnabled(false);
        pair.without = draw(root, viewpoint);
        return pair;
    }
};

TEST_F(AmbientOcclusionSceneTest, AnOpenPlaneSeesAllOfTheSky)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium,radius=2,show=occlusion", nullptr);
    group->addChild(createQuad({-10, -10, 0}, {20, 0, 0}, {0, 20, 0}, WHITE));
    for (const Viewpoint& viewpoint :
         {Viewpoint{{0, -1, 20}, {}}, Viewpoint{{0, -18, 6}, {}}, Viewpoint{{0, -1, 20}, {}, {0, 0, 1}, 8},
          Viewpoint{{9, -18, 9}, {}, {0, 0, 1}, 6}})
    {
        const osg::ref_ptr<osg::Image> image = draw(*group, viewpoint);
        for (const osg::Vec3d& place :
             {osg::Vec3d(), osg::Vec3d(1, 0, 0), osg::Vec3d(-1, 1, 0), osg::Vec3d(0.5, -1, 0)})
        {
            const osg::Vec3d color = colorAt(*image, place);
            EXPECT_GT(color.x(), 0.95) << viewpoint.eye.y() << " " << viewpoint.height;
            EXPECT_EQ(color.x(), color.y());
            EXPECT_EQ(color.x(), color.z());
        }
    }
}

TEST_F(AmbientOcclusionSceneTest, AnInnerEdgeSeesHalfOfTheSky)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createInnerEdge());
    for (const char* quality : {"low", "medium", "high"})
        for (const double height : {0.0, 4.0})
        {
            group->setSettings(parseOcclusion(std::string(quality) + ",radius=1,show=occlusion"));
            const osg::ref_ptr<osg::Image> image = draw(*group, {{0, -6, 6}, {}, {0, 0, 1}, height});
            for (const double along : {-0.7, 0.1, 0.8})
            {
                const auto visibility = [&](double y, double z) { return colorAt(*image, {along, y, z}).x(); };
                for (const double contact : {visibility(-0.06, 0.0), visibility(0.0, 0.06)})
                {
                    EXPECT_GT(contact, 0.45) << quality << " " << height;
                    EXPECT_LT(contact, 0.7) << quality << " " << height;
                }
                EXPECT_GT(visibility(-0.4, 0.0), visibility(-0.06, 0.0) + 0.1);
                EXPECT_GT(visibility(-1.4, 0.0), 0.97) << quality << " " << height;
                EXPECT_GT(visibility(0.0, 1.4), 0.97) << quality << " " << height;
            }
        }
}

TEST_F(AmbientOcclusionSceneTest, BricksOccludeAndAreOccluded)
{
    // A wall of bricks on a wider one: the front of the lower one, near and far from the edge of the protruding one.
    osg::ref_ptr<osg::Group> steps = new osg::Group;
    steps->addChild(createBrickBox({12, 1, 12}, "12"));
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("high,show=occlusion", steps);
    const Viewpoint front{{6, -30, 6.5}, {6, 0, 6.5}, {0, 0, 1}, 9};
    osg::ref_ptr<osg::Image> image = draw(*group, front);
    for (const osg::Vec3d& place : {osg::Vec3d(3.5, 0, 8.5), osg::Vec3d(6.5, 0, 6.5), osg::Vec3d(5, 0, 7)})
        EXPECT_GT(colorAt(*image, place).x(), 0.97);
    steps->addChild(createQuad({7, 0, -1}, {0, -6, 0}, {0, 0, 14}, WHITE));
    image = draw(*group, {{-3, -20, 6.5}, {6, 0, 6.5}}); // the quad seen from its side hides no brick
    EXPECT_LT(colorAt(*image, {6.85, 0, 6.5}).x(), 0.75) << "other nodes occlude bricks";
    EXPECT_GT(colorAt(*image, {3.5, 0, 6.5}).x(), 0.97);
    steps->removeChild(1);
    steps->addChild(createQuad({-10, -6, 0}, {30, 0, 0}, {0, 6, 0}, WHITE));
    image = draw(*group, {{6, -14, 12}, {6, -1, 0}});
    EXPECT_LT(colorAt(*image, {6, -0.15, 0}).x(), 0.75) << "bricks occlude other nodes";
    EXPECT_GT(colorAt(*image, {6, -5, 0}).x(), 0.95);
}

/** Whether distant bricks occlude. */
class AmbientOcclusionReach : public AmbientOcclusionSceneTest, public testing::WithParamInterface<bool>
{
};

INSTANTIATE_TEST_SUITE_P(Reaches, AmbientOcclusionReach, testing::Bool(),
                         [](const auto& reach) { return reach.param ? "distant" : "near"; });

TEST_P(AmbientOcclusionReach, VisibilityIsThatOfRaysCastAtTheBricks)
{
    osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(GetParam() ? "24" : "14"));
    lego->addChild(createRacingCar());
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", lego);
    const osg::BoundingSphere bound = lego->getBound();
    const Viewpoint viewpoint{osg::Vec3d(bound.center()) + osg::Vec3d(0.5, -0.75, 0.45) * (3.3 * bound.radius()),
                              bound.center()};
    const auto drawOutput = [&](const char* show)
    {
        group->setSettings(
            parseOcclusion(std::string("high,distant=") + (GetParam() ? "on" : "off") + ",show=" + show));
        return draw(*group, viewpoint);
    };
    const osg::ref_ptr<osg::Image> visibility = drawOutput("occlusion");
    const osg::ref_ptr<osg::Image> normals = drawOutput("normals");
    const osg::Camera& camera = *_viewer.getCamera();
    const osg::Matrixd toWorld = osg::Matrixd::inverse(camera.getViewMatrix() * camera.getProjectionMatrix() *
                                                       camera.getViewport()->computeWindowMatrix());
    const osg::Matrixd viewToWorld = camera.getInverseViewMatrix();
    const auto toGlm = [](const osg::Vec3d& vector) { return glm::dvec3(vector.x(), vector.y(), vector.z()); };

    const BrickRayCaster caster(*lego->getBricks());
    const double reach = GetParam() ? DistantOcclusion::getReach(caster.getModel().getGrid())
                                    : AmbientOcclusionSettings::RADIUS_IN_BRICKS;
    double squares = 0.0;
    int count = 0;
    for (int row = 3; row < HEIGHT; row += 5)
        for (int column = 3; column < WIDTH; column += 5)
        {
            const osg::Vec3d near = osg::Vec3d(column + 0.5, row + 0.5, 0.0) * toWorld;
            osg::Vec3d direction = osg::Vec3d(column + 0.5, row + 0.5, 1.0) * toWorld - near;
            direction.normalize();
            const glm::dvec3 start = caster.toCaster(viewpoint.eye);
            const auto distance = caster.findNearest(start, toGlm(direction), 1e6);
            const osg::Vec3d shown = readColor(*visibility, column, row);
            if (!distance || shown.x() != shown.z()) continue; // the background is blue
            osg::Vec3d normal =
                osg::Matrixd::transform3x3(readColor(*normals, column, row) * 2.0 - osg::Vec3d(1, 1, 1), viewToWorld);
            normal.normalize();
            const BrickRayCaster::Occlusion rays = caster.sampleOcclusion(
                start + *distance * toGlm(direction), toGlm(normal), reach, AmbientOcclusionSettings::FALLOFF, 64,
                static_cast<std::uint32_t>(row * WIDTH + column));
            squares += (shown.x() - rays.visibility) * (shown.x() - rays.visibility);
            ++count;
        }
    ASSERT_GT(count, 150);
    const double error = std::sqrt(squares / count);
    RecordProperty("rootMeanSquare", std::to_string(error));
    EXPECT_LE(error, GetParam() ? 0.1 : 0.08) << count << " pixels";
}

TEST_F(AmbientOcclusionSceneTest, ItIsComputedWhereverChildrenAreDrawn)
{
    const osg::ref_ptr<osg::Group> children = createMixedScene();
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", children);
    for (const Viewpoint& viewpoint :
         {MIXED_VIEW, Viewpoint{{120, -180, 140}, {4, 4, 1}}, Viewpoint{{6, 2, 3}, {4, 4, 1}}})
    {
        children->setCullingActive(true);
        const osg::ref_ptr<osg::Image> within = draw(*group, viewpoint);
        // Without culling, bounds say nothing about the area that children cover.
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

TEST_F(AmbientOcclusionSceneTest, AViewportAnywhereShowsTheSamePicture)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    osg::ref_ptr<osg::Geometry> glass =
        createQuad({1, -1, -1}, {6, 0, 0}, {0, 0, 4}, osg::Vec4(0.1f, 0.9f, 0.1f, 0.5f));
    glass->getOrCreateStateSet()->setAttributeAndModes(new osg::BlendFunc);
    glass->getStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    scene->addChild(glass);
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", scene);
    const auto drawAt = [&](int x, int y)
    {
        _viewer.getCamera()->setViewport(x, y, 120, 90);
        draw(*group, MIXED_VIEW);
        osg::ref_ptr<osg::Image> image = new osg::Image;
        _context->makeCurrent();
        image->readPixels(x, y, 120, 90, GL_RGB, GL_UNSIGNED_BYTE);
        return image;
    };
    const osg::ref_ptr<osg::Image> atOrigin = drawAt(0, 0);
    EXPECT_GT(countDrawn(*atOrigin), 1500u);
    EXPECT_LE(countDifferent(*atOrigin, *drawAt(50, 37), 1), FEW_PIXELS / 4);
}

TEST_F(AmbientOcclusionSceneTest, AViewportThatChangesItsSizeShowsWhatAFreshOneDoes)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", scene);
    for (const int width : {200, 90, 161})
    {
        const int height = width * 3 / 4;
        _viewer.getCamera()->setViewport(0, 0, width, height);
        const osg::ref_ptr<osg::Image> resized = draw(*group, MIXED_VIEW);
        EXPECT_EQ(countDifferent(*resized, *draw(*createGroup("medium", scene), MIXED_VIEW), 1), 0u) << width;
        draw(*group, MIXED_VIEW);
    }
}

TEST_F(AmbientOcclusionSceneTest, SeveralViewsOfOneSceneAreEachAsOneAlone)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const std::vector<Viewpoint> viewpoints{MIXED_VIEW, {{-14, -12, 9}, {4, 4, 1}}};
    const auto setUp = [&](osg::Camera& camera, int index)
    {
        camera.setGraphicsContext(_context);
        camera.setViewport(index * WIDTH / 2, 0, WIDTH / 2, HEIGHT);
        camera.setDrawBuffer(GL_BACK);
        camera.setReadBuffer(GL_BACK);
        viewpoints[static_cast<std::size_t>(index)].apply(camera);
    };
    const auto readHalf = [&](int index)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        _context->makeCurrent();
        image->readPixels(index * WIDTH / 2, 0, WIDTH / 2, HEIGHT, GL_RGB, GL_UNSIGNED_BYTE);
        return image;
    };
    const osg::Vec4 background = _viewer.getCamera()->getClearColor();
    std::vector<osg::ref_ptr<osg::Image>> alone;
    for (int index = 0; index < 2; ++index)
    {
        setUp(*_viewer.getCamera(), index);
        draw(*group, viewpoints[static_cast<std::size_t>(index)]);
        alone.push_back(readHalf(index));
    }
    osgViewer::CompositeViewer viewer;
    for (int index = 0; index < 2; ++index)
    {
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        setUp(*view->getCamera(), index);
        view->getCamera()->setClearColor(background);
        view->setSceneData(group);
        viewer.addView(view);
    }
    viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    viewer.setReleaseContextAtEndOfFrameHint(false);
    for (int frame = 0; frame < 2; ++frame)
    {
        viewer.frame();
        for (int index = 0; index < 2; ++index)
        {
            EXPECT_GT(countDrawn(*alone[static_cast<std::size_t>(index)]), 1500u);
            EXPECT_LE(countDifferent(*alone[static_cast<std::size_t>(index)], *readHalf(index), 1), FEW_PIXELS / 2);
        }
    }
}

TEST_F(AmbientOcclusionSceneTest, TwoParentsAreDrawnAsTwoGroupsAre)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    const auto place = [](osg::Node& first, osg::Node& second)
    {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(&first);
        osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform(
            osg::Matrix::rotate(0.6, osg::Vec3d(0.2, 0, 1)) * osg::Matrix::translate(5, -6, 3));
        moved->addChild(&second);
        root->addChild(moved);
        return root;
    };
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", scene);
    const osg::ref_ptr<osg::Group> shared = place(*group, *group);
    const osg::ref_ptr<osg::Group> apart = place(*createGroup("medium", scene), *createGroup("medium", scene));
    const Viewpoint viewpoint{{16, -34, 26}, {5, 1, 2}};
    const osg::ref_ptr<osg::Image> image = draw(*shared, viewpoint);
    EXPECT_GT(countDrawn(*image), 2000u);
    EXPECT_EQ(countDifferent(*image, *draw(*apart, viewpoint), 0), 0u);
    EXPECT_EQ(countDifferent(*image, *draw(*shared, viewpoint), 0), 0u) << "and so in later frames";
    EXPECT_EQ(countDifferent(*image, *draw(*shared, viewpoint), 0), 0u);
}

TEST_F(AmbientOcclusionSceneTest, APictureInATextureIsThatOfTheFrame)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const osg::ref_ptr<osg::Image> frame = draw(*group, MIXED_VIEW);
    const osg::ref_ptr<osg::Image> texture = drawToTexture(*group, MIXED_VIEW, 0);
    EXPECT_LE(countDifferent(*frame, *texture, 2), FEW_PIXELS);
    const osg::ref_ptr<osg::Image> relative = drawToTexture(*group, MIXED_VIEW, 0, osg::Transform::RELATIVE_RF);
    EXPECT_LE(countDifferent(*frame, *relative, 2), FEW_PIXELS);
    const osg::ref_ptr<osg::Image> smooth = drawToTexture(*group, MIXED_VIEW, 4);
    EXPECT_LT(meanDifference(*frame, *smooth), 4.0);
    EXPECT_GT(countDrawn(*smooth), countDrawn(*frame)) << "pixels of which a part is covered";
}

TEST_F(AmbientOcclusionSceneTest, AGroupWithinAGroupIsAsOne)
{
    const osg::ref_ptr<osg::Group> scene = createMixedScene();
    const osg::ref_ptr<AmbientOcclusionScene> outer = createGroup("medium", createGroup("low", scene));
    EXPECT_EQ(countDifferent(*draw(*createGroup("medium", scene), MIXED_VIEW), *draw(*outer, MIXED_VIEW), 0), 0u);
}

TEST_F(AmbientOcclusionSceneTest, ACameraForDepthsAloneGetsThem)
{
    osg::ref_ptr<osg::Image> depths = new osg::Image;
    depths->allocateImage(64, 64, 1, GL_DEPTH_COMPONENT, GL_FLOAT);
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    camera->setDrawBuffer(GL_NONE);
    camera->setReadBuffer(GL_NONE);
    camera->attach(osg::Camera::DEPTH_BUFFER, depths);
    camera->setViewport(0, 0, 64, 64);
    MIXED_VIEW.apply(*camera);
    camera->addChild(createGroup("medium", createMixedScene()));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(camera);
    draw(*root, MIXED_VIEW);
    const auto depthAt = [&](unsigned int column, unsigned int row)
    { return *reinterpret_cast<const float*>(depths->data(column, row)); };
    EXPECT_LT(depthAt(32, 32), 1.0f);
    EXPECT_GT(depthAt(32, 32), 0.0f);
    EXPECT_EQ(depthAt(0, 63), 1.0f);
}

TEST_F(AmbientOcclusionSceneTest, LightsInsideLightNodesOutside)
{
    osg::ref_ptr<osg::LightSource> lamp = new osg::LightSource;
    lamp->getLight()->setLightNum(1);
    lamp->getLight()->setPosition(osg::Vec4(4, -10, 8, 1));
    lamp->getLight()->setDiffuse(osg::Vec4(0.9f, 0.8f, 0.3f, 1.0f));
    osg::ref_ptr<osg::Group> children = new osg::Group;
    children->addChild(lamp);
    children->addChild(createBrickBox({8, 8, 2}, "8"));
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("low", children);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(createQuad({-2, 9, 0}, {12, 0, 0}, {0, 0, 6}, WHITE));
    root->addChild(group);
    root->getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
    lamp->setStateSetModes(*root->getStateSet(), osg::StateAttribute::ON);
    const osg::Vec3d place(4, 9, 5);
    const Pair pair = drawBoth(*root, *group, MIXED_VIEW);
    EXPECT_LT((colorAt(*pair.with, place) - colorAt(*pair.without, place)).length(), 0.01);
    root->getStateSet()->setMode(GL_LIGHT1, osg::StateAttribute::OFF);
    EXPECT_GT((colorAt(*pair.with, place) - colorAt(*draw(*root, MIXED_VIEW), place)).length(), 0.2);
}

TEST_F(AmbientOcclusionSceneTest, LightThatComesStraightIsTheSameInsideAndOutside)
{
    for (const bool isPlaced : {false, true})
    {
        const osg::ref_ptr<LegoNode> lego = createBrickBox({8, 8, 2}, "8", osg::Vec4(0.6f, 0.4f, 0.3f, 1.0f));
        lego->setLightProbe(createDarkProbe());
        const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", lego);
        group->setLightProbe(createDarkProbe());
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(group);
        if (isPlaced)
        {
            osg::ref_ptr<osg::LightSource> lamp = new osg::LightSource;
            lamp->getLight()->setPosition(osg::Vec4(9, -6, 8, 1));
            root->addChild(lamp);
        }
        const Pair pair = drawBoth(*root, *group, MIXED_VIEW);
        EXPECT_GT(countDrawn(*pair.with), 3000u);
        EXPECT_LE(countDifferent(*pair.with, *pair.without, 3), FEW_PIXELS) << isPlaced;
    }
}

/** Red light from +X of the world. */
osg::ref_ptr<LightProbe> createRedProbe()
{
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    std::string error;
    const auto radianceOf = [](const osg::Vec3d& direction)
    { return direction.x() > 0.6 ? osg::Vec3d(1, 0, 0) : osg::Vec3d(); };
    EXPECT_TRUE(probe->setImage(createLatitudeLongitude(64, radianceOf), LightProbe::AUTO, error)) << error;
    return probe;
}

class ProbeInTheWorld : public AmbientOcclusionSceneTest
{
protected:
    /** Compare the irradiance shown on three sides of a cube in the world with the probe's irradiance. */
    void expectIrradiance(const osg::Image& image, const LightProbe& probe, const Viewpoint& viewpoint)
    {
        for (const osg::Vec3d& normal : {osg::Vec3d(1, 0, 0), osg::Vec3d(-1, 0, 0), osg::Vec3d(0, 1, 0),
                                         osg::Vec3d(0, -1, 0), osg::Vec3d(0, 0, 1)})
        {
            if (normal * (viewpoint.eye - normal * 2.0) < 2.0) continue; // turned away
            // Between studs, if there are any.
            const osg::Vec3d place = normal * 2.0 + (normal.z() > 0.0 ? osg::Vec3d() : osg::Vec3d(0, 0, 0.2));
            const osg::Vec3d expected = probe.getIrradiance(normal);
            EXPECT_LT((colorAt(image, place) - expected).length(), normal.z() > 0.0 ? 0.25 : 0.03)
                << normal.x() << " " << normal.y() << " " << normal.z() << " from " << viewpoint.eye.x() << ": "
                << colorAt(image, place).x() << " instead of " << expected.x();
        }
    }

    static osg::ref_ptr<LegoNode> createCube(osg::Matrix& centered)
    {
        centered = osg::Matrix::translate(-2, -2, -2);
        return createBrickBox({4, 4, 4}, "4", WHITE);
    }

    const std::vector<Viewpoint> _viewpoints{{{7, -11, 5}, {}}, {{12, 3, 5}, {}}, {{-9, 8, -4}, {}}};
};

TEST_F(ProbeInTheWorld, StaysWhereItIsWhenTheCameraGoesAround)
{
    for (const double turn : {0.0, 0.5})
        for (const bool isTexture : {false, true})
        {
            const osg::ref_ptr<LightProbe> probe = createRedProbe();
            probe->setRotation(osg::Quat(turn, osg::Vec3d(0, 0, 1)));
            EXPECT_GT(probe->getIrradiance(osg::Vec3d(1, 0, 0)).x(), 0.3);
            osg::Matrix centered;
            const osg::ref_ptr<LegoNode> cube = createCube(centered);
            // A quarter turn takes the cube's sides to other sides.
            osg::ref_ptr<osg::MatrixTransform> turned =
                new osg::MatrixTransform(centered * osg::Matrix::rotate(0.5 * osg::PI, osg::Vec3d(0, 0, 1)));
            const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium,show=irradiance", cube);
            group->setLightProbe(probe);
            turned->addChild(group);
            for (const Viewpoint& viewpoint : _viewpoints)
                expectIrradiance(isTexture ? *drawToTexture(*turned, viewpoint, 0) : *draw(*turned, viewpoint), *probe,
                                 viewpoint);
        }
}

TEST_F(ProbeInTheWorld, LightsBricksWithoutAGroupToo)
{
    for (const bool isTexture : {false, true})
    {
        osg::Matrix centered;
        const osg::ref_ptr<LegoNode> cube = createCube(centered);
        cube->setLightProbe(createRedProbe());
        osg::ref_ptr<osg::MatrixTransform> turned =
            new osg::MatrixTransform(centered * osg::Matrix::rotate(0.5 * osg::PI, osg::Vec3d(0, 0, 1)));
        turned->addChild(cube);
        turned->getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
        for (const Viewpoint& viewpoint : {_viewpoints[0], _viewpoints[1]})
        {
            const osg::ref_ptr<osg::Image> image =
                isTexture ? drawToTexture(*turned, viewpoint, 0) : draw(*turned, viewpoint);
            const osg::Vec3d red = colorAt(*image, {2, 0.5, 0.5});
            EXPECT_GT(red.x(), 0.4) << isTexture;
            EXPECT_LT(red.y(), 0.1);
            const osg::Vec3d dark =
                colorAt(*image, viewpoint.eye.y() < 0.0 ? osg::Vec3d(0.5, -2, 0.5) : osg::Vec3d(0.5, 2, 0.5));
            EXPECT_LT(dark.x(), red.x() - 0.2);
        }
    }
}

TEST_F(AmbientOcclusionSceneTest, NormalsAreShownInTheEyesCoordinates)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", nullptr);
    group->addChild(createBrickBox({8, 8, 2}, "8"));
    group->addChild(createQuad({10, 0, 0}, {6, 0, 0}, {0, 8, 0}, WHITE));
    const Viewpoint viewpoint{{12, -18, 20}, {8, 4, 0}};
    for (const char* show : {"normals", "bent-normals"})
    {
        group->setSettings(parseOcclusion(std::string("medium,radius=0.5,show=") + show));
        const osg::ref_ptr<osg::Image> image = draw(*group, viewpoint);
        const auto normalAt = [&](const osg::Vec3d& place)
        {
            const osg::Vec3d eye = colorAt(*image, place) * 2.0 - osg::Vec3d(1, 1, 1);
            return osg::Matrixd::transform3x3(eye, _viewer.getCamera()->getInverseViewMatrix());
        };
        EXPECT_LT((normalAt({3.5, 3.5, 2.2125}) - osg::Vec3d(0, 0, 1)).length(), 0.1) << show << ", on a stud";
        EXPECT_LT((normalAt({4.5, 0, 1.2}) - osg::Vec3d(0, -1, 0)).length(), 0.1) << show << ", a side";
        if (show[0] == 'b')
        {
            EXPECT_LT((normalAt({13, 4, 0}) - osg::Vec3d(0, 0, 1)).length(), 0.1) << "of other nodes";
        }
    }
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

TEST_F(AmbientOcclusionSceneTest, AContextThatIsClosedAndReopenedDrawsItAgain)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const osg::ref_ptr<osg::Image> before = draw(*group, MIXED_VIEW);
    _viewer.getCamera()->setGraphicsContext(nullptr);
    group->releaseGLObjects(_context->getState());
    _context->close(true);
    _context = createContext();
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *_context, *group);
    MIXED_VIEW.apply(*viewer.getCamera());
    viewer.frame();
    EXPECT_EQ(countDifferent(*before, *readPixels(*_context), 0), 0u);
}

class AmbientOcclusionThreading : public GlTest,
                                  public ::testing::WithParamInterface<osgViewer::ViewerBase::ThreadingModel>
{
};

TEST_P(AmbientOcclusionThreading, DrawsTheSamePicture)
{
    const osg::ref_ptr<AmbientOcclusionScene> group = createGroup("medium", createMixedScene());
    const auto drawWith = [&](osgViewer::ViewerBase::ThreadingModel model)
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *group);
        MIXED_VIEW.apply(*viewer.getCamera());
        viewer.setThreadingModel(model);
        viewer.realize();
        for (int frame = 0; frame < 4; ++frame)
        {
            // Views that come and go.
            viewer.getCamera()->setViewport(0, 0, WIDTH - (3 - frame), HEIGHT);
            viewer.frame();
        }
        viewer.stopThreading();
        return readPixels(*context);
    };
    const osg::ref_ptr<osg::Image> expected = drawWith(osgViewer::ViewerBase::SingleThreaded);
    EXPECT_GT(countDrawn(*expected), 3000u);
    EXPECT_EQ(countDifferent(*expected, *drawWith(GetParam()), 0), 0u);
}

INSTANTIATE_TEST_SUITE_P(Models, AmbientOcclusionThreading,
                         ::testing::Values(osgViewer::ViewerBase::CullDrawThreadPerContext,
                                           osgViewer::ViewerBase::DrawThreadPerContext,
                                           osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext));

} // namespace

} // namespace osgLego::test
