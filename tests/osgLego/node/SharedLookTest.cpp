#include <LookTest.h>
#include <Probes.h>

#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include <osg/Depth>
#include <osg/GLObjects>
#include <osg/Geode>
#include <osg/MatrixTransform>

namespace osgLego::test
{

namespace
{

int countTextures(osg::GraphicsContext& context)
{
    constexpr GLuint MOST_TEXTURES = 1000;
    context.makeCurrent();
    osg::flushAllDeletedGLObjects(context.getState()->getContextID());
    int count = 0;
    for (GLuint name = 1; name < MOST_TEXTURES; ++name)
        count += glIsTexture(name) ? 1 : 0;
    return count;
}

osg::ref_ptr<LightProbe> createHalvedProbe(const osg::Vec3d& above, const osg::Vec3d& below)
{
    const osg::ref_ptr<osg::Image> image =
        createLatitudeLongitude(64, [&](const osg::Vec3d& direction) { return direction.z() > 0.0 ? above : below; });
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    std::string error;
    EXPECT_TRUE(probe->setImage(image, LightProbe::LATITUDE_LONGITUDE, error)) << error;
    return probe;
}

constexpr double STEP = 8.0; // from one node to the next, in world units; nodes are 4 units wide
constexpr unsigned int NUM_ACROSS = 4;

// The direction that is up in the pictures, in which the nodes are seen from the front and from above.
const osg::Vec3d UP(0, std::sqrt(0.5), std::sqrt(0.5));

osg::Vec3d placeOf(std::size_t index)
{
    return osg::Vec3d(STEP * static_cast<double>(index % NUM_ACROSS), 0, 0) -
           UP * (STEP * static_cast<double>(index / NUM_ACROSS));
}

// Twelve places side by side, a whole number of pixels apart.
const osg::Vec3d FIELD_CENTRE = osg::Vec3d(1.5 * STEP + 2, 2, 2) - UP * STEP;
const Viewpoint FIELD_VIEW{FIELD_CENTRE + osg::Vec3d(0, -40, 40), FIELD_CENTRE, UP, 25.0};

osg::ref_ptr<osg::MatrixTransform> createPlaced(osg::Node& node, const osg::Vec3d& place)
{
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(osg::Matrix::translate(place));
    transform->addChild(&node);
    return transform;
}

/** Creates one of the nodes that differ in everything on which their states depend. */
using NodeMaker = std::function<osg::ref_ptr<LegoNode>()>;

NodeMaker makeWith(const std::string& settings, const std::function<void(LegoNode&)>& change)
{
    return [=]
    {
        const osg::ref_ptr<LegoNode> lego = createBrickBox({4, 4, 4}, settings, {0.8f, 0.3f, 0.2f, 1.0f});
        lego->setWaiting(true);
        change(*lego);
        return lego;
    };
}

NodeMaker makeWithAppearance(const std::string& settings, const std::function<void(BrickAppearance&)>& change)
{
    return makeWith(settings,
                    [=](LegoNode& lego)
                    {
                        BrickAppearance appearance;
                        change(appearance);
                        EXPECT_TRUE(lego.setAppearance(appearance));
                    });
}

NodeMaker makeWithProbe(const std::string& settings, const osg::ref_ptr<LightProbe>& probe)
{
    return makeWith(settings, [=](LegoNode& lego) { lego.setLightProbe(probe); });
}

/** A copy of a probe, which has the same light. */
osg::ref_ptr<LightProbe> createTurnedProbe(const LightProbe& probe, const osg::Quat& rotation, double intensity)
{
    const osg::ref_ptr<LightProbe> copy = new LightProbe(probe);
    copy->setRotation(rotation);
    copy->setIntensity(intensity);
    return copy;
}

NodeMaker makeWithRelief(const std::string& settings, int period)
{
    return makeWithAppearance(settings,
                              [period](BrickAppearance& look)
                              {
                                  const osg::ref_ptr<osg::Image> image = new osg::Image;
                                  image->allocateImage(16, 16, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
                                  for (int row = 0; row < 16; ++row)
                                      for (int column = 0; column < 16; ++column)
                                          *image->data(static_cast<unsigned int>(column),
                                                       static_cast<unsigned int>(row)) =
                                              (column + row) % period < period / 2 ? 255 : 0;
                                  look.reliefHeight = 0.2;
                                  look.reliefImage = image;
                              });
}

/** Nodes that each differ from the others in a property on which their states depend. */
std::vector<NodeMaker> createMakers(const std::string& drawing)
{
    const std::string ending = ",drawing=" + drawing;
    const osg::ref_ptr<LightProbe> probe = createHalvedProbe({0.9, 0.9, 0.2}, {0.1, 0.1, 0.4});
    const osg::Quat onItsSide(osg::PI_2, osg::Vec3d(0, 1, 0));
    return {makeWith("4,look=plain" + ending, [](LegoNode&) {}),
            makeWith("4" + ending, [](LegoNode&) {}),
            makeWithRelief("2" + ending, 4),
            makeWithRelief("2" + ending, 16),
            makeWithAppearance("4" + ending, [](BrickAppearance& look) { look.roughness = 1.0; }),
            makeWithAppearance("4" + ending, [](BrickAppearance& look) { look.variation = 3.0; }),
            makeWithAppearance("4" + ending, [](BrickAppearance& look) { look.joints = false; }),
            makeWithProbe("4" + ending, probe),
            makeWithProbe("4" + ending, createTurnedProbe(*probe, {}, 0.4)),
            makeWithProbe("4" + ending, createTurnedProbe(*probe, onItsSide, 1.0)),
            makeWithProbe("4" + ending, createHalvedProbe({0.1, 0.8, 0.1}, {0.5, 0.0, 0.0})),
            makeWith("4" + ending, [](LegoNode& lego) { lego.setBuildProgress(0.5); })};
}

class SharedLook : public LookTest, public ::testing::WithParamInterface<std::tuple<const char*, bool>>
{
protected:
    void SetUp() override
    {
        LookTest::SetUp();
        _viewer.frame(); // creates the GL functions
    }

    static std::string getDrawing() { return std::get<0>(GetParam()); }

    /** An empty scene, with or without ambient occlusion from a radius that does not depend on the nodes. */
    static osg::ref_ptr<osg::Group> createScene()
    {
        if (!std::get<1>(GetParam())) return new osg::Group;
        return createGroup("medium,radius=0.5", nullptr);
    }

    /** A partly built node is drawn whole until its order of building is known, in the first frame. */
    osg::ref_ptr<osg::Image> drawField(osg::Node& scene)
    {
        draw(scene, FIELD_VIEW);
        return draw(scene, FIELD_VIEW);
    }

    /** Draw frames without nodes, since the viewer keeps those of its last two frames. */
    void dropLastFrames() { drawField(*osg::ref_ptr<osg::Group>(new osg::Group)); }

    /** The pixels of a picture around the node in one place. */
    osg::ref_ptr<osg::Image> cutOut(const osg::Image& picture, std::size_t index) const
    {
        const osg::Vec3d centre = pixelOf(placeOf(index) + osg::Vec3d(2, 2, 2));
        const auto side = static_cast<int>(STEP * HEIGHT / FIELD_VIEW.height);
        const osg::ref_ptr<osg::Image> result = new osg::Image;
        result->allocateImage(side, side, 1, picture.getPixelFormat(), picture.getDataType());
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                result->setColor(
                    picture.getColor(static_cast<unsigned int>(std::lround(centre.x()) - side / 2 + column),
                                     static_cast<unsigned int>(std::lround(centre.y()) - side / 2 + row)),
                    static_cast<unsigned int>(column), static_cast<unsigned int>(row));
        return result;
    }
};

/** Without an AmbientOcclusionScene, in which nodes have textures of distant occlusion, and a stage of its own draws
 * bricks before other surfaces. */
class SharedLookWithoutOcclusion : public SharedLook
{
};

TEST_P(SharedLook, NodesOfDifferentLooksKeepTheirOwnPictures)
{
    const std::vector<NodeMaker> makers = createMakers(getDrawing());
    std::vector<osg::ref_ptr<osg::Image>> alone;
    for (std::size_t index = 0; index < makers.size(); ++index)
    {
        const osg::ref_ptr<osg::Group> scene = createScene();
        scene->addChild(createPlaced(*makers[index](), placeOf(index)));
        alone.push_back(cutOut(*drawField(*scene), index));
        dropLastFrames();
    }
    // In an AmbientOcclusionScene, the probe of the scene replaces those of the nodes.
    const bool showsProbes = !std::get<1>(GetParam());
    for (std::size_t index = 0; showsProbes && index < makers.size(); ++index)
        for (std::size_t other = 0; other < index; ++other)
            EXPECT_GT(countDifferent(*alone[index], *alone[other], 2), 20u) << index << " and " << other;
    const osg::ref_ptr<osg::Group> scene = createScene();
    for (std::size_t index = 0; index < makers.size(); ++index)
        scene->addChild(createPlaced(*makers[index](), placeOf(index)));
    const osg::ref_ptr<osg::Image> together = drawField(*scene);
    // The tiles in which occlusion is searched cover neighbouring nodes, which may change the rounding of a pixel.
    const int tolerance = std::get<1>(GetParam()) ? 1 : 0;
    for (std::size_t index = 0; index < makers.size(); ++index)
        EXPECT_EQ(countDifferent(*cutOut(*together, index), *alone[index], tolerance), 0u) << index;
}

TEST_P(SharedLookWithoutOcclusion, NodesOfOneLookHaveTheTexturesOfOneNode)
{
    const osg::ref_ptr<LightProbe> probe = createHalvedProbe({1, 1, 1}, {0, 0, 0});
    const NodeMaker make = makeWith("4,device=cpu,drawing=" + getDrawing(),
                                    [=](LegoNode& lego)
                                    {
                                        lego.setLightProbe(probe);
                                        BrickAppearance appearance; // occlusion is that of a node's own bricks
                                        appearance.occlusion = BrickOcclusion::OFF;
                                        lego.setAppearance(appearance);
                                    });
    const osg::ref_ptr<osg::Group> scene = createScene();
    scene->addChild(createPlaced(*make(), placeOf(0)));
    drawField(*scene);
    const int one = countTextures(*_context);
    // Each node copies the probe, but not its light.
    for (std::size_t index = 1; index < 10; ++index)
        scene->addChild(createPlaced(*make(), placeOf(index)));
    drawField(*scene);
    EXPECT_EQ(countTextures(*_context), one);
}

TEST_P(SharedLook, AContextThatClosesLeavesTheOthersTheirPictures)
{
    const NodeMaker make = makeWith("4,drawing=" + getDrawing(), [](LegoNode&) {});
    const osg::ref_ptr<osg::Group> scene = createScene();
    scene->addChild(createPlaced(*make(), placeOf(0)));
    const osg::ref_ptr<osg::Image> before = drawField(*scene);
    {
        const osg::ref_ptr<osg::Group> other = createScene();
        other->addChild(createPlaced(*make(), placeOf(0)));
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *other);
        FIELD_VIEW.apply(*viewer.getCamera());
        viewer.frame();
        EXPECT_EQ(countDifferent(*readPixels(*context), *before, 0), 0u);
        context->close();
    }
    _context->makeCurrent(); // the viewer takes it to be current
    EXPECT_EQ(countDifferent(*drawField(*scene), *before, 0), 0u);
    scene->addChild(createPlaced(*make(), placeOf(1)));
    EXPECT_EQ(countDifferent(*cutOut(*drawField(*scene), 0), *cutOut(*before, 0), 0), 0u);
}

TEST_P(SharedLook, AContextThatTakesOverTheIdOfAClosedOneDrawsBricks)
{
    const NodeMaker make = makeWith("4,drawing=" + getDrawing(), [](LegoNode&) {});
    const osg::ref_ptr<osg::Group> scene = createScene();
    scene->addChild(createPlaced(*make(), placeOf(0)));
    const osg::ref_ptr<osg::Image> before = drawField(*scene);
    const auto show = [](osgViewer::Viewer& viewer, osg::GraphicsContext& context, osg::Node& node)
    {
        setUpViewer(viewer, context, node);
        FIELD_VIEW.apply(*viewer.getCamera());
        viewer.frame();
    };
    unsigned int contextID = 0;
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        contextID = context->getState()->getContextID();
        osgViewer::Viewer viewer;
        osg::ref_ptr<osg::Group> other = createScene();
        other->addChild(createPlaced(*make(), placeOf(0)));
        show(viewer, *context, *other);
        other = nullptr;
        for (int frame = 0; frame < 3; ++frame)
            show(viewer, *context, *osg::ref_ptr<osg::Group>(new osg::Group));
        context->close();
    }
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    ASSERT_EQ(context->getState()->getContextID(), contextID);
    osgViewer::Viewer viewer;
    show(viewer, *context, *scene);
    EXPECT_EQ(countDifferent(*readPixels(*context), *before, 0), 0u);
}

/** Two nodes behind each other. @param between drawn after the first and before the second; may be null. */
osg::ref_ptr<osg::Group> createRow(const std::string& drawing, osg::Group& scene, osg::Node* between)
{
    const NodeMaker make = makeWith("4,drawing=" + drawing, [](LegoNode&) {});
    scene.addChild(createPlaced(*make(), {0, 0, 0}));
    if (between)
    {
        scene.addChild(between);
        scene.getOrCreateStateSet()->setRenderBinDetails(0, "TraversalOrderBin");
    }
    const osg::ref_ptr<LegoNode> behind = createBrickBox({12, 4, 8}, "12,drawing=" + drawing, {0.2f, 0.3f, 0.8f, 1.0f});
    behind->setWaiting(true);
    scene.addChild(createPlaced(*behind, {-4, 8, -2}));
    return &scene;
}

const Viewpoint FRONT_VIEW{{2, -40, 2}, {2, 0, 2}};
const Viewpoint SIDE_VIEW{{30, -30, 2}, {2, 0, 2}};

TEST_P(SharedLook, AFrameThatIsDrawnAgainFromAnotherViewpointShowsItsOwnPicture)
{
    // Otherwise, the projection depends on the viewpoint.
    _viewer.getCamera()->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    const osg::ref_ptr<osg::Group> scene = createRow(getDrawing(), *createScene(), nullptr);
    const osg::ref_ptr<osg::Image> front = draw(*scene, FRONT_VIEW);
    const osg::ref_ptr<osg::Image> side = draw(*scene, SIDE_VIEW);
    draw(*scene, FRONT_VIEW);
    // With the same frame number, as a program does that draws several pictures of one moment.
    SIDE_VIEW.apply(*_viewer.getCamera());
    _viewer.renderingTraversals();
    EXPECT_EQ(countDifferent(*readPixels(*_context), *side, 0), 0u);
    FRONT_VIEW.apply(*_viewer.getCamera());
    _viewer.renderingTraversals();
    EXPECT_EQ(countDifferent(*readPixels(*_context), *front, 0), 0u);
}

TEST_P(SharedLookWithoutOcclusion, ASurfaceDrawnBetweenTwoNodesMayMoveDepthsAway)
{
    // It replaces the first node and its depths by the far plane, in which the second node then appears.
    const auto createEraser = []
    {
        const osg::ref_ptr<osg::Geometry> quad =
            createQuad({-20, -10, -20}, {50, 0, 0}, {0, 0, 50}, {0.0f, 0.0f, 0.0f, 1.0f});
        quad->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        quad->getOrCreateStateSet()->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 1.0, 1.0));
        return quad;
    };
    const osg::ref_ptr<osg::Image> expected = draw(*createRow("triangles", *createScene(), createEraser()), FRONT_VIEW);
    const osg::ref_ptr<osg::Image> found = draw(*createRow(getDrawing(), *createScene(), createEraser()), FRONT_VIEW);
    EXPECT_LE(countDifferent(*found, *expected, 8), FEW_PIXELS);
}

std::string nameOf(const ::testing::TestParamInfo<SharedLook::ParamType>& parameters)
{
    const auto& [drawing, isOccluded] = parameters.param;
    return std::string(drawing) + (isOccluded ? "Occluded" : "Alone");
}

INSTANTIATE_TEST_SUITE_P(Drawings, SharedLook,
                         ::testing::Combine(::testing::Values("splats", "triangles"), ::testing::Bool()), nameOf);
INSTANTIATE_TEST_SUITE_P(Drawings, SharedLookWithoutOcclusion,
                         ::testing::Combine(::testing::Values("splats", "triangles"), ::testing::Values(false)),
                         nameOf);

} // namespace

} // namespace osgLego::test
