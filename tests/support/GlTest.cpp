#include "GlTest.h"

#include "GlDebug.h"
#include "GlslValidator.h"
#include "Settings.h"

#include <offscreen/OffscreenContext.h>
#include <osgLego/gl/GlRequirements.h>

#include <cstdlib>
#include <stdexcept>

#include <osg/Math>

namespace osgLego::test
{

namespace
{

const osg::Vec4 BACKGROUND(0.0f, 0.0f, 0.2f, 1.0f);

/** Lets the CPU find the bricks of all LegoNodes, and the frame wait for them. */
class CpuUser : public osg::NodeVisitor
{
public:
    CpuUser() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    void apply(osg::Group& group) override
    {
        if (auto* lego = dynamic_cast<LegoNode*>(&group))
        {
            LegoSettings settings = lego->getSettings();
            settings.voxelization.device = Device::CPU;
            lego->setSettings(settings);
            lego->setWaiting(true);
        }
        traverse(group);
    }
};

void failOnGlMessages()
{
    for (const std::string& message : takeGlMessages())
        ADD_FAILURE() << "GL: " << message;
}

} // namespace

GlTest::GlTest()
{
    watchPrograms();
}

GlTest::~GlTest()
{
    // The contexts of derived classes have been closed.
    failOnGlMessages();
    for (const std::string& error : takeProgramErrors())
        ADD_FAILURE() << "GLSL: " << error;
}

void GlTest::TearDown()
{
    failOnGlMessages();
}

osg::ref_ptr<osg::GraphicsContext> GlTest::createContext(int display)
{
    std::string error;
    osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(WIDTH, HEIGHT, error, display);
    if (!context) throw std::runtime_error(error);
    watchGl(*context);
    return context;
}

osg::ref_ptr<osg::GraphicsContext> GlTest::createCoreContext(const std::string& version)
{
    std::string error;
    osg::ref_ptr<osg::GraphicsContext> context = createOffscreenContext(WIDTH, HEIGHT, error, 0, version);
    if (!context) throw std::runtime_error(error);
    context->getState()->setUseModelViewAndProjectionUniforms(true);
    context->getState()->setUseVertexAttributeAliasing(true);
    watchGl(*context);
    return context;
}

void GlTest::setUpViewer(osgViewer::Viewer& viewer, osg::GraphicsContext& context, osg::Node& scene)
{
    osg::Camera* camera = viewer.getCamera();
    camera->setGraphicsContext(&context);
    camera->setViewport(0, 0, WIDTH, HEIGHT);
    camera->setDrawBuffer(GL_BACK);
    camera->setReadBuffer(GL_BACK);
    camera->setClearColor(BACKGROUND);
    camera->setProjectionMatrixAsPerspective(30.0, static_cast<double>(WIDTH) / HEIGHT, 0.1, 100.0);
    const osg::BoundingSphere bound = scene.getBound();
    const osg::Vec3d toEye(0.4, -0.8, 0.45);
    camera->setViewMatrixAsLookAt(osg::Vec3d(bound.center()) + toEye * (4.2 * bound.radius()), bound.center(),
                                  osg::Vec3d(0, 0, 1));
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer.setReleaseContextAtEndOfFrameHint(false);
    viewer.setSceneData(&scene);
}

osg::ref_ptr<osg::Image> GlTest::readPixels(osg::GraphicsContext& context)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    context.makeCurrent();
    image->readPixels(0, 0, WIDTH, HEIGHT, GL_RGB, GL_UNSIGNED_BYTE);
    return image;
}

osg::ref_ptr<osg::Image> GlTest::drawWithCpu(const osg::Node& scene, const osg::Camera& camera)
{
    const osg::ref_ptr<osg::Node> copy = osg::clone(&scene, osg::CopyOp::DEEP_COPY_NODES);
    CpuUser user;
    copy->accept(user);
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *copy);
    viewer.getCamera()->setViewMatrix(camera.getViewMatrix());
    viewer.getCamera()->setProjectionMatrix(camera.getProjectionMatrix());
    viewer.frame();
    return readPixels(*context);
}

void GlTest::expectPictureOfCpu(osg::GraphicsContext& context, const osg::Node& scene, const osg::Camera& camera)
{
    const osg::ref_ptr<osg::Image> expected = drawWithCpu(scene, camera);
    EXPECT_GT(countDrawn(*expected), 1000u) << "the picture is empty";
    // The passes work in single precision: cells that a triangle merely grazes may differ.
    constexpr std::size_t MOST_DIFFERENT = 10;
    // Reading makes the context current again, as its viewer left it.
    EXPECT_LE(countDifferent(*expected, *readPixels(context), 3), MOST_DIFFERENT);
}

bool GlTest::isSoftware(osg::GraphicsContext& context)
{
    context.makeCurrent();
    GlRequirements::getMissing(*context.getState());
    return GlRequirements::getRenderer(context.getState()->getContextID()) == Renderer::SOFTWARE;
}

osg::ref_ptr<const BrickModel> GlTest::legolizeOnGpu(osg::Node& source, const LegoSettings& settings,
                                                     LegoStatistics* statistics)
{
    const osg::ref_ptr<osg::GraphicsContext> context = createContext();
    osg::ref_ptr<LegoNode> lego = new LegoNode(settings);
    lego->setReadBack(true);
    lego->addChild(&source);
    osgViewer::Viewer viewer;
    setUpViewer(viewer, *context, *lego);
    viewer.frame();
    const unsigned int contextID = context->getState()->getContextID();
    EXPECT_TRUE(lego->isLegolized(contextID)) << lego->getFailure(contextID);
    if (statistics) *statistics = lego->getStatistics(contextID);
    return lego->getBricks(contextID);
}

LegoSettings GlTest::parseSettings(const std::string& text)
{
    return test::parseSettings(text, test::parseSettings("device=gpu"));
}

std::size_t countDrawn(const osg::Image& image)
{
    std::size_t count = 0;
    for (int row = 0; row < image.t(); ++row)
        for (int column = 0; column < image.s(); ++column)
        {
            const unsigned char* pixel = image.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            if (pixel[0] != 0 || pixel[1] != 0 || pixel[2] != 51) ++count;
        }
    return count;
}

std::size_t countDifferent(const osg::Image& a, const osg::Image& b, int tolerance)
{
    std::size_t count = 0;
    for (int row = 0; row < a.t(); ++row)
        for (int column = 0; column < a.s(); ++column)
        {
            const unsigned char* first = a.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            const unsigned char* second = b.data(static_cast<unsigned int>(column), static_cast<unsigned int>(row));
            for (int channel = 0; channel < 3; ++channel)
                if (std::abs(first[channel] - second[channel]) > tolerance)
                {
                    ++count;
                    break;
                }
        }
    return count;
}

} // namespace osgLego::test
