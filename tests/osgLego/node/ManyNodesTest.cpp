#include <common/RacingCar.h>

#include <LookTest.h>
#include <Meshes.h>
#include <Probes.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <osg/Depth>
#include <osg/GLExtensions>
#include <osg/MatrixTransform>
#include <osg/PolygonOffset>
#include <osg/Scissor>
#include <osgUtil/SceneView>

namespace osgLego::test
{

namespace
{

/** Counts the programs that are linked in a context, during its lifetime. */
class LinkCount
{
public:
    explicit LinkCount(osg::GraphicsContext& context) : _extensions(*context.getState()->get<osg::GLExtensions>())
    {
        count = 0;
        linkProgram = _extensions.glLinkProgram;
        _extensions.glLinkProgram = [](GLuint program)
        {
            ++count;
            linkProgram(program);
        };
    }
    ~LinkCount() { _extensions.glLinkProgram = linkProgram; }
    LinkCount(const LinkCount&) = delete;
    LinkCount& operator=(const LinkCount&) = delete;

    static inline int count = 0;

private:
    static inline decltype(osg::GLExtensions::glLinkProgram) linkProgram = nullptr;

    osg::GLExtensions& _extensions;
};

/** Several nodes in a scene, which share programs, textures and the target of splats. */
class ManyNodes : public LookTest
{
protected:
    using Nodes = std::vector<osg::ref_ptr<LegoNode>>;

    static constexpr std::size_t NUM_DIFFERENT = 10;

    const Viewpoint _view{{5, -16, 9}, {0, 0, 0.5}};

    static osg::ref_ptr<LegoNode> createCar(const std::string& settings)
    {
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings));
        lego->setWaiting(true);
        lego->addChild(createRacingCar());
        return lego;
    }

    /** Place nodes in rows of four, from the back to the front. */
    static void place(const Nodes& nodes, osg::Group& scene, double step)
    {
        for (std::size_t index = 0; index < nodes.size(); ++index)
        {
            const double column = static_cast<double>(index % 4) - 1.5;
            const double row = static_cast<double>(index / 4) - 1.0;
            osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(
                osg::Matrix::scale(0.4, 0.4, 0.4) * osg::Matrix::translate(step * column, -1.6 * step * row, 0));
            transform->addChild(nodes[index]);
            scene.addChild(transform);
        }
    }

    static osg::ref_ptr<LightProbe> createLamp(const osg::Vec3d& color)
    {
        osg::ref_ptr<LightProbe> lamp = new LightProbe;
        std::string error;
        const auto radiance = [&color](const osg::Vec3d& d)
        { return d.x() > 0.97 ? color * 60.0 : osg::Vec3d(1, 1, 1); };
        EXPECT_TRUE(lamp->setImage(createLatitudeLongitude(64, radiance), LightProbe::AUTO, error)) << error;
        return lamp;
    }

    /** Ten nodes, each with another look. */
    static Nodes createDifferent()
    {
        Nodes nodes;
        for (const char* settings :
             {"12", "12,look=plain", "12,palette=ldraw", "12,drawing=triangles", "12", "12", "12", "12", "12", "12"})
            nodes.push_back(createCar(settings));
        BrickAppearance appearance;
        appearance.roughness = 0.9;
        nodes[4]->setAppearance(appearance);
        appearance.joints = false;
        appearance.outline = 2.0;
        nodes[5]->setAppearance(appearance);
        const osg::ref_ptr<LightProbe> lamp = createLamp({1.0, 0.2, 0.2});
        nodes[6]->setLightProbe(lamp);
        nodes[7]->setLightProbe(createLamp({0.2, 1.0, 0.2}));
        const osg::ref_ptr<LightProbe> turned = new LightProbe(*lamp); // with the same light
        turned->setRotation(osg::Quat(1.5, osg::Vec3d(0, 0, 1)));
        turned->setIntensity(2.0);
        nodes[8]->setLightProbe(turned);
        nodes[9]->setBuildProgress(0.6);
        return nodes;
    }

    /** The first frame shows how nodes wait for the order of building. */
    osg::ref_ptr<osg::Image> drawTwice(osg::Node& scene)
    {
        draw(scene, _view);
        return draw(scene, _view);
    }

    static osg::ref_ptr<osg::Group> createScene(bool hasOcclusion)
    {
        // Hardly any occlusion by neighbours.
        return hasOcclusion ? createGroup("low,radius=0.5", nullptr).get() : osg::ref_ptr(new osg::Group);
    }

    /** The picture of the nodes of createDifferent(), put together from pictures of each node alone. */
    osg::ref_ptr<osg::Image> drawOneByOne(bool hasOcclusion)
    {
        osg::ref_ptr<osg::Image> result;
        for (std::size_t shown = 0; shown < NUM_DIFFERENT; ++shown)
        {
            const osg::ref_ptr<osg::Group> scene = createScene(hasOcclusion);
            place(createDifferent(), *scene, 2.2);
            const osg::ref_ptr<osg::Node> kept = scene->getChild(static_cast<unsigned int>(shown));
            scene->removeChildren(0, scene->getNumChildren());
            scene->addChild(kept);
            const osg::ref_ptr<osg::Image> picture = drawTwice(*scene);
            _viewer.setSceneData(nullptr); // so that the next node shares nothing with this one
            EXPECT_GT(countDrawn(*picture), std::size_t(WIDTH * HEIGHT / 200)) << "node " << shown;
            if (!result) result = new osg::Image(*picture, osg::CopyOp::DEEP_COPY_ALL);
            for (int row = 0; row < HEIGHT; ++row)
                for (int column = 0; column < WIDTH; ++column)
                    if (picture->getColor(column, row) != picture->getColor(0, 0))
                        result->setColor(picture->getColor(column, row), column, row);
        }
        return result;
    }

    /** Bricks with a polygon offset are drawn as triangles; this offset has no effect. */
    osg::ref_ptr<osg::Image> drawTriangles(osg::Node& scene)
    {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(&scene);
        group->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(0.0f, 0.0f));
        return draw(*group, _view);
    }

    /** A view with one render stage, unlike osgViewer's, of which two take turns. */
    osg::ref_ptr<osgUtil::SceneView> createSceneView(osg::Node& scene)
    {
        osg::ref_ptr<osgUtil::SceneView> view = new osgUtil::SceneView;
        view->setDefaults();
        view->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR); // the projection shows no difference
        view->setCamera(_viewer.getCamera(), false);
        view->setState(_context->getState());
        view->setSceneData(&scene);
        const osg::ref_ptr<osg::FrameStamp> frame = new osg::FrameStamp;
        frame->setFrameNumber(1000);
        view->setFrameStamp(frame);
        return view;
    }

    osg::ref_ptr<osg::Image> drawSceneView(osgUtil::SceneView& view)
    {
        _context->makeCurrent();
        view.cull();
        view.draw();
        return readPixels(*_context);
    }

    enum class Occlusion
    {
        NONE,
        ONE_SCENE,
        SCENE_FOR_EACH_NODE //!< as the files of paged tiles have
    };

    int countLinked(int numNodes, const std::string& settings, Occlusion occlusion)
    {
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        const osg::ref_ptr<osg::Group> scene =
            occlusion == Occlusion::ONE_SCENE ? createGroup("low", nullptr).get() : osg::ref_ptr(new osg::Group);
        Nodes nodes;
        for (int node = 0; node < numNodes; ++node)
            nodes.push_back(createCar(settings));
        place(nodes, *scene, 2.2);
        if (occlusion == Occlusion::SCENE_FOR_EACH_NODE)
            for (unsigned int child = 0; child < scene->getNumChildren(); ++child)
                scene->setChild(child, createGroup("low", scene->getChild(child)));
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *scene);
        scene->setNodeMask(0);
        viewer.frame(); // for the functions of GL
        scene->setNodeMask(~0u);
        const LinkCount linked(*context);
        viewer.frame();
        for (const osg::ref_ptr<LegoNode>& node : nodes)
            EXPECT_TRUE(node->isLegolized(context->getState()->getContextID()));
        return LinkCount::count;
    }
};

TEST_F(ManyNodes, WithEqualSettingsLinkAsManyProgramsAsOne)
{
    for (const char* settings : {"8", "8,look=plain", "8,device=cpu"})
        for (const Occlusion occlusion : {Occlusion::NONE, Occlusion::ONE_SCENE, Occlusion::SCENE_FOR_EACH_NODE})
        {
            const int one = countLinked(1, settings, occlusion);
            EXPECT_GT(one, 0);
            EXPECT_EQ(countLinked(10, settings, occlusion), one) << settings << " " << static_cast<int>(occlusion);
        }
}

TEST_F(ManyNodes, WithDifferentLooksKeepTheirPictures)
{
    for (const bool hasOcclusion : {false, true})
    {
        osg::ref_ptr<osg::Image> together;
        {
            const osg::ref_ptr<osg::Group> scene = createScene(hasOcclusion);
            place(createDifferent(), *scene, 2.2);
            together = drawTwice(*scene);
            _viewer.setSceneData(nullptr);
        }
        // The occlusion of a pixel depends slightly on neighbours in the picture.
        EXPECT_EQ(countDifferent(*together, *drawOneByOne(hasOcclusion), hasOcclusion ? 3 : 0), 0u) << hasOcclusion;
        if (hasOcclusion) continue;
        // The lamps differ in colour.
        const osg::Vec3d red = colorAt(*together, osg::Vec3d(0.5 * 2.2, 0, 0.2));
        const osg::Vec3d green = colorAt(*together, osg::Vec3d(1.5 * 2.2, 0, 0.2));
        EXPECT_GT((red - green).length(), 0.02);
    }
}

TEST_F(ManyNodes, HideEachOtherLikeTriangles)
{
    for (const bool hasOcclusion : {false, true})
        for (const bool isReversed : {false, true})
        {
            const osg::ref_ptr<osg::Group> scene =
                hasOcclusion ? createGroup("low", nullptr).get() : osg::ref_ptr(new osg::Group);
            Nodes nodes;
            for (const char* settings : {"12", "9", "12", "14,look=plain", "12", "12", "12", "12"})
                nodes.push_back(createCar(settings));
            if (isReversed) std::reverse(nodes.begin(), nodes.end());
            nodes[2]->setBuildProgress(0.6);
            place(nodes, *scene, isReversed ? -0.5 : 0.5);
            const osg::ref_ptr<osg::Image> splats = drawTwice(*scene);
            EXPECT_LE(countDifferent(*splats, *drawTriangles(*scene), 3), 2 * FEW_PIXELS) << hasOcclusion << isReversed;
        }
}

TEST_F(ManyNodes, AreDrawnAgainInAFrameWithTheSameNumber)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    place({createCar("12"), createCar("12"), createCar("12,look=plain")}, *scene, 0.5);
    drawTwice(*scene);
    const osg::ref_ptr<osgUtil::SceneView> view = createSceneView(*scene);
    std::vector<osg::ref_ptr<osg::Image>> pictures;
    for (int repeat = 0; repeat < 3; ++repeat)
        pictures.push_back(drawSceneView(*view));
    EXPECT_GT(countDrawn(*pictures[0]), std::size_t(WIDTH * HEIGHT / 200));
    EXPECT_EQ(countDifferent(*pictures[0], *pictures[1], 0), 0u);
    EXPECT_EQ(countDifferent(*pictures[0], *pictures[2], 0), 0u);
}

TEST_F(ManyNodes, AreNotHiddenByThoseOfAnotherPictureWithTheSameFrameNumber)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    const Nodes nodes{createCar("12"), createCar("14")};
    place(nodes, *scene, 0.0); // one inside the other
    const auto show = [&](std::size_t shown)
    {
        for (std::size_t node = 0; node < nodes.size(); ++node)
            nodes[node]->setNodeMask(node == shown ? ~0u : 0u);
    };
    drawTwice(*scene);
    show(1);
    const osg::ref_ptr<osgUtil::SceneView> first = createSceneView(*scene);
    const osg::ref_ptr<osg::Image> expected = drawSceneView(*first);
    show(0);
    const osg::ref_ptr<osgUtil::SceneView> view = createSceneView(*scene);
    EXPECT_GT(countDifferent(*drawSceneView(*view), *expected, 0), 100u);
    show(1);
    EXPECT_EQ(countDifferent(*drawSceneView(*view), *expected, 0), 0u);
}

TEST_F(ManyNodes, AreDrawnAtEachPlaceOfANode)
{
    const osg::ref_ptr<osg::Group> instances = new osg::Group;
    const osg::ref_ptr<LegoNode> car = createCar("12");
    place(Nodes(8, car), *instances, 0.5);
    const osg::ref_ptr<osg::Group> copies = new osg::Group;
    Nodes nodes;
    for (int node = 0; node < 8; ++node)
        nodes.push_back(createCar("12"));
    place(nodes, *copies, 0.5);
    EXPECT_EQ(countDifferent(*drawTwice(*instances), *drawTwice(*copies), 0), 0u);
}

TEST_F(ManyNodes, OfWhichOneIsReleasedOrDeletedKeepTheirPicture)
{
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    Nodes nodes;
    for (int node = 0; node < 4; ++node)
        nodes.push_back(createCar("12"));
    place(nodes, *scene, 2.2);
    nodes[0]->setNodeMask(0);
    const osg::ref_ptr<osg::Image> others = drawTwice(*scene);
    nodes[0]->setNodeMask(~0u);
    drawTwice(*scene);
    _context->makeCurrent();
    nodes[0]->releaseGLObjects(_context->getState());
    scene->removeChild(0, 1);
    EXPECT_EQ(countDifferent(*draw(*scene, _view), *others, 0), 0u) << "released";
    nodes[0] = nullptr;
    EXPECT_EQ(countDifferent(*draw(*scene, _view), *others, 0), 0u) << "deleted";
    nodes[1]->releaseGLObjects();
    EXPECT_EQ(countDifferent(*draw(*scene, _view), *others, 0), 0u) << "released in all contexts";
}

TEST_F(ManyNodes, OfWhichOneIsReleasedKeepTheirPrograms)
{
    for (const char* settings : {"12,device=cpu", "12,device=gpu", "12,look=plain"})
        for (const bool hasOcclusion : {false, true})
        {
            const osg::ref_ptr<osg::Group> scene = createScene(hasOcclusion);
            const Nodes nodes{createCar(settings), createCar(settings)};
            place(nodes, *scene, 2.2);
            drawTwice(*scene);
            const LinkCount linked(*_context);
            nodes[0]->releaseGLObjects(_context->getState());
            nodes[1]->dirty();
            drawTwice(*scene);
            nodes[0]->releaseGLObjects();
            nodes[1]->dirty();
            drawTwice(*scene);
            EXPECT_EQ(LinkCount::count, 0) << settings << hasOcclusion;
            scene->releaseGLObjects(_context->getState());
            drawTwice(*scene);
            EXPECT_GT(LinkCount::count, 0) << "all were released";
            _viewer.setSceneData(nullptr);
        }
}

TEST_F(ManyNodes, BehindAMaskedNodeAreVisible)
{
    // Nodes that hide nothing, or only a part of the picture, must not hide the bricks behind them.
    const std::vector<std::function<void(osg::StateSet&)>> changes{
        [](osg::StateSet& stateSet)
        { stateSet.setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false)); },
        [](osg::StateSet& stateSet) { stateSet.setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.9999, 1.0)); },
        [](osg::StateSet& stateSet) { stateSet.setAttributeAndModes(new osg::Scissor(0, 0, WIDTH / 2, HEIGHT)); }};
    for (std::size_t change = 0; change < changes.size(); ++change)
    {
        const osg::ref_ptr<osg::Group> scene = new osg::Group;
        const Nodes nodes{createCar("12"), createCar("14")};
        place(nodes, *scene, 0.3);
        changes[change](*nodes[0]->getOrCreateStateSet());
        EXPECT_LE(countDifferent(*drawTwice(*scene), *drawTriangles(*scene), 3), 2 * FEW_PIXELS) << change;
    }
}

TEST_F(ManyNodes, WithOneSourceSeeItsUnannouncedChangesAfterDirty)
{
    const osg::ref_ptr<osg::Geometry> triangle = createTriangle({-1, 0, -1}, {1, 0, -1}, {0, 0, 1});
    const auto create = [&]
    {
        osg::ref_ptr<LegoNode> node = new LegoNode(parseSettings("16,device=cpu"));
        node->addChild(triangle);
        return node;
    };
    const osg::ref_ptr<LegoNode> changed = create();
    const osg::ref_ptr<LegoNode> other = create();
    const std::size_t before = changed->getBricks()->getBricks().size();
    EXPECT_EQ(other->getBricks()->getBricks().size(), before);
    // Without a call of dirty() for the array.
    (*static_cast<osg::Vec3Array*>(triangle->getVertexArray()))[2].set(1.0f, 0.0f, -0.9f);
    changed->dirty();
    const std::size_t after = changed->getBricks()->getBricks().size();
    EXPECT_LT(after, before);
    EXPECT_EQ(create()->getBricks()->getBricks().size(), after);
    // A node that is new needs no such call.
    const osg::ref_ptr<LegoNode> kept = create();
    EXPECT_EQ(kept->getBricks()->getBricks().size(), after);
    (*static_cast<osg::Vec3Array*>(triangle->getVertexArray()))[2].set(0.0f, 0.0f, 1.0f);
    EXPECT_EQ(create()->getBricks()->getBricks().size(), before);
    (*static_cast<osg::Vec3Array*>(triangle->getVertexArray()))[2].set(1.0f, 0.0f, -0.9f);
    changed->setSettings(parseSettings("17,device=cpu"));
    changed->setSettings(parseSettings("16,device=cpu"));
    EXPECT_EQ(changed->getBricks()->getBricks().size(), after);
}

} // namespace

} // namespace osgLego::test
