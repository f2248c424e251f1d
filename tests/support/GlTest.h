#pragma once

#include <osgLego/LegoNode.h>

#include <gtest/gtest.h>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/Node>
#include <osgViewer/Viewer>

namespace osgLego::test
{

/** A test with a GL context of its own, without a display. Fails on any GL error and message of high severity. */
class GlTest : public ::testing::Test
{
public:
    // Of the contexts' own frame buffers, in pixels.
    static constexpr int WIDTH = 200;
    static constexpr int HEIGHT = 150;

protected:
    void SetUp() override;
    void TearDown() override;

    /** A context that is watched, realized and not current. */
    static osg::ref_ptr<osg::GraphicsContext> createContext();

    /** Let a viewer draw a scene into a context, as far away as it all fits in. */
    static void setUpViewer(osgViewer::Viewer& viewer, osg::GraphicsContext& context, osg::Node& scene);

    /** What a context's own frame buffer shows. */
    static osg::ref_ptr<osg::Image> readPixels(osg::GraphicsContext& context);

    /** Legolize in a new context and bring the covered cells back. When that fails, fails the test and answers null. */
    static osg::ref_ptr<const BrickModel> legolizeOnGpu(osg::Node& source, const LegoSettings& settings,
                                                        LegoStatistics* statistics = nullptr);

    /** By the passes of the GPU, a software renderer's too, unless the text names a device. */
    static LegoSettings parseSettings(const std::string& text);
};

/** How many pixels of a picture are not the background. */
std::size_t countDrawn(const osg::Image& image);

/** How many pixels of two pictures of one size differ by more than `tolerance` of 255 in some channel. */
std::size_t countDifferent(const osg::Image& a, const osg::Image& b, int tolerance);

} // namespace osgLego::test
