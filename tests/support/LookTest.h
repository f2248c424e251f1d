#pragma once

#include "GlTest.h"

#include <osgLego/AmbientOcclusionScene.h>
#include <osgLego/LegoNode.h>
#include <osgLego/LightProbe.h>

#include <string>

#include <osg/Geometry>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osgViewer/Viewer>

namespace osgLego::test
{

/** A camera position. */
struct Viewpoint
{
    osg::Vec3d eye;
    osg::Vec3d target;
    osg::Vec3d up{0, 0, 1};
    double height = 0.0; //!< of an orthographic picture, in world units; 0 for perspective

    void apply(osg::Camera& camera) const;
};

// A wall of cells in y = 0, seen from the front: so many pixels each, a border between cells in the middle of the
// picture.
constexpr int WALL_PIXELS = 15;
const Viewpoint WALL_VIEW{{10, -30, 10}, {10, 0, 10}, {0, 0, 1}, static_cast<double>(GlTest::HEIGHT) / WALL_PIXELS};

/** A test that draws pictures of several scenes with one context and one viewer. */
class LookTest : public GlTest
{
protected:
    void SetUp() override;

    /** The viewer's first frame of a scene. */
    osg::ref_ptr<osg::Image> draw(osg::Node& scene, const Viewpoint& viewpoint);

    /** The colour, 0 to 1, of a world position in the viewer's last picture: the mean of its pixel and the pixel's
     * neighbours. */
    osg::Vec3d colorAt(const osg::Image& image, const osg::Vec3d& place) const;
    /** The position of that pixel, with fractions, from the left and from the bottom. */
    osg::Vec3d pixelOf(const osg::Vec3d& place) const;

    osg::ref_ptr<osg::GraphicsContext> _context;
    osgViewer::Viewer _viewer;
};

AmbientOcclusionSettings parseOcclusion(const std::string& text);

/** A group with settings in their text form. */
osg::ref_ptr<AmbientOcclusionScene> createGroup(const std::string& settings, osg::Node* child);

/** Bricks that replace a box with a corner at the origin; each is 1 wide if the box is as long as the resolution. */
osg::ref_ptr<LegoNode> createBrickBox(const osg::Vec3& size, const std::string& settings,
                                      const osg::Vec4& color = osg::Vec4(0.8f, 0.8f, 0.8f, 1.0f));

/** A parallelogram with the normal `across` x `up`. */
osg::ref_ptr<osg::Geometry> createQuad(const osg::Vec3& corner, const osg::Vec3& across, const osg::Vec3& up,
                                       const osg::Vec4& color);

/** A probe without light. */
osg::ref_ptr<LightProbe> createDarkProbe();

/** The colour of a pixel of the picture, 0 to 1. */
osg::Vec3d readColor(const osg::Image& image, int column, int row);

/** The mean of its channels. */
double brightnessAt(const osg::Image& image, int column, int row);

/** The mean of all pixels. */
double meanBrightness(const osg::Image& image);

/** The root mean square of the steps in brightness from a pixel to the next in its row, without five columns at each
 * side. */
double stepBetweenPixels(const osg::Image& image);

/** The mean absolute difference of two pictures over pixels and channels, 0 to 255. */
double meanDifference(const osg::Image& a, const osg::Image& b);

} // namespace osgLego::test
