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

/** Where a scene is looked at from. */
struct Viewpoint
{
    osg::Vec3d eye;
    osg::Vec3d target;
    osg::Vec3d up{0, 0, 1};
    double height = 0.0; //!< of an orthographic picture, in units of the world; 0: in perspective

    void apply(osg::Camera& camera) const;
};

/** A test with one context and one viewer, for pictures of several scenes. */
class LookTest : public GlTest
{
protected:
    void SetUp() override;

    /** What the viewer's first frame of a scene shows. */
    osg::ref_ptr<osg::Image> draw(osg::Node& scene, const Viewpoint& viewpoint);

    /** The colour, 0 to 1, of the pixel where a place of the world is in the viewer's last picture, the mean of it and
     * its neighbours. */
    osg::Vec3d colorAt(const osg::Image& image, const osg::Vec3d& place) const;
    /** That pixel, fractions included, from the left and from the bottom. */
    osg::Vec3d pixelOf(const osg::Vec3d& place) const;

    osg::ref_ptr<osg::GraphicsContext> _context;
    osgViewer::Viewer _viewer;
};

AmbientOcclusionSettings parseOcclusion(const std::string& text);

/** A group with settings by their text form. */
osg::ref_ptr<AmbientOcclusionScene> createGroup(const std::string& settings, osg::Node* child);

/** Bricks in place of a box with a corner in the origin, one unit each where its longest side is the resolution. */
osg::ref_ptr<LegoNode> createBrickBox(const osg::Vec3& size, const std::string& settings,
                                      const osg::Vec4& color = osg::Vec4(0.8f, 0.8f, 0.8f, 1.0f));

/** A parallelogram, its normal being across x up. */
osg::ref_ptr<osg::Geometry> createQuad(const osg::Vec3& corner, const osg::Vec3& across, const osg::Vec3& up,
                                       const osg::Vec4& color);

/** A probe without light. */
osg::ref_ptr<LightProbe> createDarkProbe();

/** 0 to 1, of the picture's pixel. */
osg::Vec3d readColor(const osg::Image& image, int column, int row);

/** The mean over pixels and channels of how far two pictures are apart, 0 to 255. */
double meanDifference(const osg::Image& a, const osg::Image& b);

} // namespace osgLego::test
