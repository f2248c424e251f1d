#include <common/RacingCar.h>
#include <osgLego/BrickGeometry.h>

#include <LookTest.h>

#include <algorithm>

#include <osg/ClipNode>
#include <osg/CullFace>
#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osg/PolygonMode>
#include <osg/ShapeDrawable>

namespace osgLego::test
{

namespace
{

/** Compares bricks, drawn either way (LegoSettings::View::drawing), with the same bricks as plain triangles, drawn by
 * OSG. */
class Polygonization : public GlTest, public ::testing::WithParamInterface<const char*>
{
protected:
    /** Draw bricks, or their triangles, with an ordinary node that intersects them. */
    osg::ref_ptr<osg::Image> draw(osg::Node& bricks, const std::function<void(osg::StateSet&)>& change = {})
    {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        osg::ref_ptr<osg::Geode> ball = new osg::Geode;
        ball->addDrawable(new osg::ShapeDrawable(new osg::Sphere(osg::Vec3(0.2f, -0.5f, 0.4f), 0.45f)));
        root->addChild(ball);
        root->addChild(&bricks);
        // Without lighting, which need not be the same for both.
        root->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        if (change) change(*root->getStateSet());
        const osg::ref_ptr<osg::GraphicsContext> context = createContext();
        osgViewer::Viewer viewer;
        setUpViewer(viewer, *context, *root);
        viewer.frame();
        if (auto* lego = dynamic_cast<LegoNode*>(&bricks))
            _cells = lego->getBricks(context->getState()->getContextID());
        return readPixels(*context);
    }

    osg::ref_ptr<LegoNode> createLego(const std::string& settings)
    {
        osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings(settings + ",drawing=" + GetParam()));
        lego->addChild(createRacingCar());
        return lego;
    }

    osg::ref_ptr<const BrickModel> _cells; // read back with the last picture

    static osg::ref_ptr<osg::Node> toTriangles(const LegoNode& lego)
    {
        osg::ref_ptr<osg::Geode> geode = new osg::Geode;
        geode->addDrawable(createBrickGeometry(*lego.getBricks()));
        return geode;
    }
};

TEST_P(Polygonization, DrawsTheBricksAsTheyAreInDepthAndColour)
{
    for (const char* settings :
         {"20", "20,proportions=brick", "24,proportions=plate", "20,up=y", "20,up=y,proportions=plate"})
    {
        const osg::ref_ptr<LegoNode> lego = createLego(settings);
        const osg::ref_ptr<osg::Image> bricks = draw(*lego);
        const osg::ref_ptr<osg::Image> triangles = draw(*toTriangles(*lego));
        EXPECT_GT(countDrawn(*bricks), 3000u);
        EXPECT_LE(countDifferent(*bricks, *triangles, 2), FEW_PIXELS) << settings;
    }
}

TEST_P(Polygonization, AStudOutOfPlaceWouldBeSeen)
{
    // Shows that the comparison above can fail.
    const osg::ref_ptr<LegoNode> lego = createLego("20");
    osg::ref_ptr<osg::MatrixTransform> moved = new osg::MatrixTransform(osg::Matrix::translate(0, 0, 0.1));
    moved->addChild(toTriangles(*lego));
    EXPECT_GT(countDifferent(*draw(*lego), *draw(*moved), 2), FEW_PIXELS);
}

TEST_P(Polygonization, EveryFaceWindsOutwards)
{
    const osg::ref_ptr<LegoNode> lego = createLego("20");
    const auto cullBack = [](osg::StateSet& stateSet) { stateSet.setAttributeAndModes(new osg::CullFace); };
    EXPECT_EQ(countDifferent(*draw(*lego), *draw(*lego, cullBack), 0), 0u);
    const osg::ref_ptr<LegoNode> upright = createLego("20,up=y");
    EXPECT_EQ(countDifferent(*draw(*upright), *draw(*upright, cullBack), 0), 0u);
}

TEST_P(Polygonization, IsLitByTheLightsThatAreOn)
{
    const auto light = [](unsigned int modes)
    {
        return [modes](osg::StateSet& stateSet)
        {
            stateSet.setMode(GL_LIGHTING, modes & 1 ? osg::StateAttribute::ON : osg::StateAttribute::OFF);
            stateSet.setMode(GL_LIGHT0, (modes & 2 ? osg::StateAttribute::ON : osg::StateAttribute::OFF) |
                                            osg::StateAttribute::OVERRIDE);
        };
    };
    // The full look has environment light even without any light.
    const osg::ref_ptr<LegoNode> lego = createLego("20,look=plain");
    const osg::ref_ptr<osg::Image> plain = draw(*lego, light(0));
    const osg::ref_ptr<osg::Image> lit = draw(*lego, light(3));
    const osg::ref_ptr<osg::Image> dark = draw(*lego, light(1));
    const auto brightness = [](const osg::Image& image)
    {
        double sum = 0.0;
        for (unsigned int byte = 0; byte < image.getTotalSizeInBytes(); ++byte)
            sum += image.data()[byte];
        return sum;
    };
    EXPECT_GT(brightness(*plain), brightness(*lit));
    EXPECT_GT(brightness(*lit), 1.3 * brightness(*dark));
}

TEST_P(Polygonization, AWireFrameStaysWithinTheBricks)
{
    const auto asLines = [](osg::StateSet& stateSet)
    {
        stateSet.setMode(GL_LIGHTING, osg::StateAttribute::ON);
        stateSet.setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE));
    };
    for (const char* settings : {"20,look=plain", "20,look=full"})
        for (const bool isInGroup : {false, true})
        {
            osg::ref_ptr<osg::Node> bricks = createLego(settings);
            if (isInGroup) bricks = createGroup("medium", bricks);
            const osg::ref_ptr<osg::Image> filled = draw(*bricks);
            const osg::ref_ptr<osg::Image> lines = draw(*bricks, asLines);
            const osg::Vec4 background = filled->getColor(0, 0);
            const auto isDrawnNear = [&](int column, int row)
            {
                for (int y = std::max(row - 1, 0); y <= std::min(row + 1, HEIGHT - 1); ++y)
                    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, WIDTH - 1); ++x)
                        if (filled->getColor(static_cast<unsigned int>(x), static_cast<unsigned int>(y)) != background)
                            return true;
                return false;
            };
            int outside = 0;
            for (int row = 0; row < HEIGHT; ++row)
                for (int column = 0; column < WIDTH; ++column)
                    if (lines->getColor(static_cast<unsigned int>(column), static_cast<unsigned int>(row)) !=
                            background &&
                        !isDrawnNear(column, row))
                        ++outside;
            EXPECT_EQ(outside, 0) << settings << isInGroup;
            EXPECT_GT(countDifferent(*lines, *filled, 8), countDrawn(*filled) / 10) << "these are no lines";
            EXPECT_GT(countDrawn(*lines), countDrawn(*filled) / 3) << settings << isInGroup;
        }
}

TEST_P(Polygonization, StateOfTheSceneAroundDoesNotDisturbThePasses)
{
    const osg::ref_ptr<LegoNode> lego = createLego("20");
    lego->setReadBack(true);
    draw(*lego);
    const osg::ref_ptr<const BrickModel> expected = _cells;
    ASSERT_TRUE(expected);
    draw(*lego,
         [](osg::StateSet& stateSet)
         {
             const auto strongly = osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE;
             stateSet.setMode(GL_BLEND, strongly);
             stateSet.setMode(GL_SCISSOR_TEST, strongly);
             stateSet.setMode(GL_ALPHA_TEST, strongly);
             stateSet.setMode(GL_STENCIL_TEST, strongly);
             stateSet.setMode(GL_CLIP_PLANE0, strongly);
             stateSet.setMode(GL_CULL_FACE, strongly);
             stateSet.setAttributeAndModes(
                 new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE), strongly);
             osg::ref_ptr<osg::Program> program = new osg::Program;
             program->addShader(new osg::Shader(osg::Shader::FRAGMENT, "void main() { gl_FragColor = vec4(1.0); }"));
             stateSet.setAttribute(program, strongly);
         });
    ASSERT_TRUE(_cells);
    EXPECT_EQ(_cells->getBricks(), expected->getBricks());
}

TEST_P(Polygonization, ForeignProgramsDoNotDrawTheBricks)
{
    const osg::ref_ptr<LegoNode> lego = createLego("20");
    const osg::ref_ptr<osg::Image> plain = draw(*lego);
    const osg::ref_ptr<osg::Image> overridden =
        draw(*lego,
             [](osg::StateSet& stateSet)
             {
                 osg::ref_ptr<osg::Program> program = new osg::Program;
                 program->addShader(new osg::Shader(
                     osg::Shader::VERTEX, "void main() { gl_FrontColor = gl_Color; gl_Position = ftransform(); }"));
                 program->addShader(new osg::Shader(osg::Shader::FRAGMENT, "void main() { gl_FragColor = gl_Color; }"));
                 stateSet.setAttribute(program, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
             });
    EXPECT_LE(countDifferent(*plain, *overridden, 2), FEW_PIXELS);
}

TEST_P(Polygonization, ClipPlanesCutTheBricks)
{
    const osg::ref_ptr<LegoNode> lego = createLego("20");
    const auto cut = [](osg::Node& node)
    {
        osg::ref_ptr<osg::ClipNode> clip = new osg::ClipNode;
        clip->addClipPlane(new osg::ClipPlane(0, osg::Vec4d(1, 0, 0, 0)));
        clip->addChild(&node);
        return clip;
    };
    const osg::ref_ptr<osg::Image> bricks = draw(*cut(*lego));
    EXPECT_LE(countDifferent(*bricks, *draw(*cut(*toTriangles(*lego))), 2), FEW_PIXELS);
    EXPECT_GT(countDifferent(*bricks, *draw(*lego), 2), 10 * FEW_PIXELS) << "the plane cuts nothing";
}

TEST_P(Polygonization, ThePassesLeaveTheStateOfTheSceneAsItWas)
{
    // An ordinary textured node, drawn after the bricks, in a frame in which the passes run and in one without them.
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<LegoNode> lego = createLego("24");
    lego->setWaiting(true); // or it keeps the distant occlusion of earlier bricks for a while
    root->addChild(lego);
    osg::ref_ptr<osg::MatrixTransform> beside = new osg::MatrixTransform(osg::Matrix::translate(0, 0, 1.5));
    beside->addChild(createRacingCar());
    root->addChild(beside);
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *root);
    viewer.frame();
    const osg::ref_ptr<osg::Image> first = readPixels(*context);
    viewer.frame();
    EXPECT_EQ(countDifferent(*first, *readPixels(*context), 0), 0u);
    lego->dirty();
    viewer.frame();
    EXPECT_EQ(countDifferent(*first, *readPixels(*context), 0), 0u);
}

INSTANTIATE_TEST_SUITE_P(BothWays, Polygonization, ::testing::Values("triangles", "splats"),
                         [](const ::testing::TestParamInfo<const char*>& way) { return std::string(way.param); });

} // namespace

} // namespace osgLego::test
