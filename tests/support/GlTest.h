#pragma once

#include <osgLego/LegoNode.h>

#include <gtest/gtest.h>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/Node>
#include <osgViewer/Viewer>

namespace osgLego::test
{

/** A test with its own GL context, without a display. Fails on any GL error or message of high severity, including
 * those of contexts that close after the test, and on any program that glslangValidator rejects. */
class GlTest : public ::testing::Test
{
public:
    // The size of the contexts' own frame buffers, in pixels.
    static constexpr int WIDTH = 200;
    static constexpr int HEIGHT = 150;
    // Two ways of drawing may round the same edge to either of two neighbouring pixels: so many pixels may differ.
    static constexpr std::size_t FEW_PIXELS = WIDTH * HEIGHT / 500;

    GlTest();
    ~GlTest() override;

protected:
    void TearDown() override;

    /** A context that is watched for errors, realized, and not current. @param display see createOffscreenContext(). */
    static osg::ref_ptr<osg::GraphicsContext> createContext(int display = 0);
    /** Likewise of the core profile, with a state that uses uniforms for matrices. @param version such as "4.1". */
    static osg::ref_ptr<osg::GraphicsContext> createCoreContext(const std::string& version);

    /** Let a viewer draw a scene into a context, from a distance at which all of it is visible. */
    static void setUpViewer(osgViewer::Viewer& viewer, osg::GraphicsContext& context, osg::Node& scene);

    /** The picture in a context's own frame buffer. */
    static osg::ref_ptr<osg::Image> readPixels(osg::GraphicsContext& context);

    /** Draw a scene as a camera sees it, with bricks that the CPU finds: a copy of the scene in another context. */
    static osg::ref_ptr<osg::Image> drawWithCpu(const osg::Node& scene, const osg::Camera& camera);

    /** Expect that a context shows the picture of drawWithCpu(). The context is current afterwards. */
    static void expectPictureOfCpu(osg::GraphicsContext& context, const osg::Node& scene, const osg::Camera& camera);

    /** Legolize in a new context and read the covered cells back. @return null on failure, which fails the test. */
    static osg::ref_ptr<const BrickModel> legolizeOnGpu(osg::Node& source, const LegoSettings& settings,
                                                        LegoStatistics* statistics = nullptr);

    /** Whether a context's OpenGL is a software renderer; GPUs round in other ways. The context is current afterwards.
     */
    static bool isSoftware(osg::GraphicsContext& context);

    /** Parse settings; unless the text names a device, the passes of the GPU run, even on a software renderer. */
    static LegoSettings parseSettings(const std::string& text);
};

/** The number of pixels of a picture that differ from the background. */
std::size_t countDrawn(const osg::Image& image);

/** The number of pixels of two pictures of the same size that differ by more than `tolerance` of 255 in a channel. */
std::size_t countDifferent(const osg::Image& a, const osg::Image& b, int tolerance);

} // namespace osgLego::test
