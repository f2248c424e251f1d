#include <common/RacingCar.h>

#include <LookTest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <osg/ColorMask>
#include <osg/CullFace>
#include <osg/GLExtensions>
#include <osg/PolygonOffset>

namespace osgLego::test
{

namespace
{

using Modes = void (*)(osg::StateSet& stateSet);

void cull(osg::StateSet& stateSet, osg::CullFace::Mode mode)
{
    stateSet.setAttributeAndModes(new osg::CullFace(mode));
}

/** As techniques of osgShadow. */
void offset(osg::StateSet& stateSet)
{
    stateSet.setAttributeAndModes(new osg::PolygonOffset(1.1f, 4.0f));
}

struct NamedModes
{
    const char* name;
    Modes set;
};

constexpr NamedModes ALL_MODES[]{
    {"no modes", [](osg::StateSet&) {}},
    {"front faces culled", [](osg::StateSet& stateSet) { cull(stateSet, osg::CullFace::FRONT); }},
    {"back faces culled, offset",
     [](osg::StateSet& stateSet)
     {
         cull(stateSet, osg::CullFace::BACK);
         offset(stateSet);
     }},
    {"front faces culled, offset", [](osg::StateSet& stateSet)
     {
         cull(stateSet, osg::CullFace::FRONT);
         offset(stateSet);
     }}};

/** The number of primitives that a camera draws. */
class PrimitiveCount
{
public:
    explicit PrimitiveCount(osg::Camera& camera)
    {
        camera.setPreDrawCallback(new Callback(*this, true));
        camera.setPostDrawCallback(new Callback(*this, false));
    }

    GLuint get() const { return _count; }

private:
    struct Callback : public osg::Camera::DrawCallback
    {
        Callback(PrimitiveCount& parent, bool begins) : count(parent), isStart(begins) {}

        void operator()(osg::RenderInfo& renderInfo) const override
        {
            const osg::GLExtensions& extensions = *renderInfo.getState()->get<osg::GLExtensions>();
            if (isStart)
            {
                extensions.glGenQueries(1, &count._query);
                extensions.glBeginQuery(GL_PRIMITIVES_GENERATED, count._query);
                return;
            }
            extensions.glEndQuery(GL_PRIMITIVES_GENERATED);
            extensions.glGetQueryObjectuiv(count._query, GL_QUERY_RESULT, &count._count);
            extensions.glDeleteQueries(1, &count._query);
        }

        PrimitiveCount& count;
        bool isStart;
    };

    GLuint _query = 0;
    GLuint _count = 0;
};

/** Compares depths of bricks in cameras with and without colours. */
class DepthPass : public LookTest
{
protected:
    static constexpr int SIDE = 256; // of pictures, in pixels

    enum class Colors
    {
        ATTACHED,
        MASKED, //!< attached, and masked
        NONE
    };

    struct Picture
    {
        std::vector<float> depths;
        GLuint numPrimitives = 0;
    };

    static osg::ref_ptr<LegoNode> createCar(const std::string& settings)
    {
        const osg::ref_ptr<LegoNode> lego = new LegoNode(parseSettings("24,device=cpu,look=plain," + settings));
        lego->setWaiting(true);
        lego->addChild(createRacingCar());
        return lego;
    }

    /** A camera whose depths become an image. */
    osg::ref_ptr<osg::Camera> createDepthCamera(const Viewpoint& viewpoint, osg::Image& image) const
    {
        image.allocateImage(SIDE, SIDE, 1, GL_DEPTH_COMPONENT, GL_FLOAT);
        osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        camera->setReferenceFrame(osg::Camera::ABSOLUTE_RF);
        camera->setRenderOrder(osg::Camera::PRE_RENDER);
        camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera->setViewport(0, 0, SIDE, SIDE);
        camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
        viewpoint.apply(*camera);
        if (viewpoint.height > 0.0)
        {
            camera->setProjectionMatrixAsOrtho(-0.5 * viewpoint.height, 0.5 * viewpoint.height, -0.5 * viewpoint.height,
                                               0.5 * viewpoint.height, 1.0, 13.0);
            camera->setProjectionMatrix(camera->getProjectionMatrix() * _warp);
        }
        else
            camera->setProjectionMatrixAsPerspective(30.0, 1.0, 3.0, 20.0);
        camera->attach(osg::Camera::DEPTH_BUFFER, &image);
        return camera;
    }

    Picture drawDepths(osg::Node& node, const Viewpoint& viewpoint, Modes modes, Colors colors)
    {
        const osg::ref_ptr<osg::Image> image = new osg::Image;
        const osg::ref_ptr<osg::Camera> camera = createDepthCamera(viewpoint, *image);
        if (colors != Colors::NONE) camera->attach(osg::Camera::COLOR_BUFFER, GL_RGBA);
        if (colors == Colors::MASKED)
            camera->getOrCreateStateSet()->setAttribute(new osg::ColorMask(false, false, false, false));
        modes(*camera->getOrCreateStateSet());
        camera->addChild(&node);
        const PrimitiveCount primitives(*camera);
        draw(*camera, viewpoint);
        const auto* depths = reinterpret_cast<const float*>(image->data());
        return {{depths, depths + SIDE * SIDE}, primitives.get()};
    }

    osg::Matrixd _warp; // of orthographic pictures

    /** The change of the depth from a pixel to its neighbours, along both axes; at an edge, that on one of its sides.
     */
    static float slopeAt(const std::vector<float>& depths, std::size_t pixel)
    {
        const auto least = [&](std::size_t place, std::size_t step)
        {
            const float before = place > 0 ? std::abs(depths[pixel] - depths[pixel - step]) : 1.0f;
            const float after = place + 1 < SIDE ? std::abs(depths[pixel + step] - depths[pixel]) : 1.0f;
            return std::min(before, after);
        };
        return least(pixel % SIDE, 1) + least(pixel / SIDE, SIDE);
    }

    /** Expect the same depths, except in a few pixels at edges. */
    void expectSame(const Picture& actual, const Picture& expected)
    {
        constexpr float ROUNDING = 2e-6f;
        // GPUs round the corners of triangles to 1 / 256 of a pixel, and move their planes.
        constexpr float CORNER_ROUNDING = 1.0f / 256.0f; // pixels
        const bool isExact = isSoftware(*_context);
        std::size_t numDrawn = 0;
        std::size_t numWrong = 0;
        float largest = 0.0f;
        for (std::size_t pixel = 0; pixel < expected.depths.size(); ++pixel)
        {
            if (expected.depths[pixel] < 1.0f) ++numDrawn;
            const float difference = std::abs(actual.depths[pixel] - expected.depths[pixel]);
            largest = std::max(largest, difference);
            const float slope = isExact ? 0.0f : slopeAt(expected.depths, pixel);
            if (difference > ROUNDING + CORNER_ROUNDING * slope) ++numWrong;
        }
        EXPECT_GT(numDrawn, 5000u);
        // Walls of studs are triangles narrower than a pixel, whose planes GPUs move further.
        EXPECT_LT(numWrong, numDrawn / (isExact ? 200 : 40)) << "the largest difference is " << largest;
    }
};

TEST_F(DepthPass, GivesTheDepthsOfShadedBricks)
{
    const Viewpoint viewpoints[]{{{4.0, -7.0, 6.0}, {0.0, 0.0, 0.4}},
                                 {{1.5, 4.0, -7.0}, {0.0, 0.0, 0.4}},
                                 {{3.0, -5.0, 4.0}, {0.0, 0.0, 0.4}, {0, 0, 1}, 4.2},
                                 {{-1.0, 0.5, 6.0}, {0.0, 0.0, 0.4}, {0, 1, 0}, 4.2}};
    const osg::ref_ptr<LegoNode> shaded = createCar("drawing=triangles");
    for (const char* drawing : {"splats", "triangles"})
    {
        const osg::ref_ptr<LegoNode> lego = createCar(std::string("drawing=") + drawing);
        for (const NamedModes& modes : ALL_MODES)
            for (const Viewpoint& viewpoint : viewpoints)
            {
                SCOPED_TRACE(std::string(drawing) + ", " + modes.name + ", from " + std::to_string(viewpoint.eye.z()));
                expectSame(drawDepths(*lego, viewpoint, modes.set, Colors::NONE),
                           drawDepths(*shaded, viewpoint, modes.set, Colors::ATTACHED));
            }
    }
}

TEST_F(DepthPass, GivesTheDepthsOfShadedBricksInLightSpacePerspective)
{
    // Larger at the lower edge of the picture.
    _warp = osg::Matrixd(0.5, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 0.5, 0, 0, 0.5, 0, 1);
    const Viewpoint viewpoint{{3.0, -5.0, 4.0}, {0.0, 0.0, 0.4}, {0, 0, 1}, 4.2};
    const osg::ref_ptr<LegoNode> shaded = createCar("drawing=triangles");
    const osg::ref_ptr<LegoNode> lego = createCar("drawing=splats");
    for (const NamedModes& modes : ALL_MODES)
    {
        SCOPED_TRACE(modes.name);
        const Picture actual = drawDepths(*lego, viewpoint, modes.set, Colors::NONE);
        expectSame(actual, drawDepths(*shaded, viewpoint, modes.set, Colors::ATTACHED));
        EXPECT_LE(actual.numPrimitives, lego->getBricks()->getBricks().size());
    }
}

TEST_F(DepthPass, OfPointsEndsAtTheViewport)
{
    constexpr int HALF = SIDE / 2;
    const Viewpoint viewpoint{{3.0, -5.0, 4.0}, {0.0, 0.0, 0.4}, {0, 0, 1}, 1.0}; // within the car
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    const osg::ref_ptr<osg::Camera> camera = createDepthCamera(viewpoint, *image);
    draw(*camera, viewpoint); // clears the whole target
    camera->setViewport(0, 0, HALF, HALF);
    camera->addChild(createCar("drawing=splats"));
    draw(*camera, viewpoint);
    // OSG reads the viewport.
    camera->removeChildren(0, 1);
    camera->setViewport(0, 0, SIDE, SIDE);
    camera->setClearMask(0);
    draw(*camera, viewpoint);

    std::size_t numInside = 0;
    std::size_t numOutside = 0;
    for (int row = 0; row < SIDE; ++row)
        for (int column = 0; column < SIDE; ++column)
        {
            const bool isDrawn = *reinterpret_cast<const float*>(image->data(column, row)) < 1.0f;
            (row < HALF && column < HALF ? numInside : numOutside) += isDrawn ? 1 : 0;
        }
    EXPECT_GT(numInside, HALF * HALF / 2u);
    EXPECT_EQ(numOutside, 0u);
}

TEST_F(DepthPass, DrawsNoMoreThanAPointForEachBrick)
{
    const osg::ref_ptr<LegoNode> lego = createCar("drawing=splats");
    const Viewpoint viewpoint{{3.0, -5.0, 4.0}, {0.0, 0.0, 0.4}, {0, 0, 1}, 4.2};
    for (const Colors colors : {Colors::NONE, Colors::MASKED})
    {
        const GLuint number = drawDepths(*lego, viewpoint, offset, colors).numPrimitives;
        EXPECT_GT(number, 100u);
        EXPECT_LE(number, lego->getBricks()->getBricks().size());
    }
    EXPECT_GT(drawDepths(*lego, viewpoint, offset, Colors::ATTACHED).numPrimitives,
              lego->getBricks()->getBricks().size())
        << "shaded bricks with an offset are triangles";
}

} // namespace

} // namespace osgLego::test
