#pragma once

#include <LookTest.h>

#include <cstddef>

#include <osg/Camera>
#include <osg/Geode>
#include <osg/Group>
#include <osg/Image>

namespace osgLego::test
{

inline const osg::Vec4 WHITE(1.0f, 1.0f, 1.0f, 1.0f);

void switchLighting(osg::Node& node, bool isOn);

osg::ref_ptr<osg::Geode> createBall(const osg::Vec3& center, float radius, const osg::Vec4& color);

/** A scene of bricks and other nodes: a ball on a box of 8 x 8 x 2. */
osg::ref_ptr<osg::Group> createMixedScene();

inline const Viewpoint MIXED_VIEW{{12, -18, 14}, {4, 4, 1}};

/** Draws scenes with ambient occlusion. */
class AmbientOcclusionTest : public LookTest
{
protected:
    /** A picture with and without a group around a node. */
    struct Pair
    {
        osg::ref_ptr<osg::Image> with;
        osg::ref_ptr<osg::Image> without;
    };

    /** The picture of a scene below a camera that renders to a texture, `scale` times as large as the window. */
    osg::ref_ptr<osg::Image> drawToTexture(osg::Node& scene, const Viewpoint& viewpoint, unsigned int samples,
                                           osg::Transform::ReferenceFrame frame = osg::Transform::ABSOLUTE_RF,
                                           int scale = 1);

    Pair drawBoth(osg::Node& root, AmbientOcclusionScene& group, const Viewpoint& viewpoint);
};

} // namespace osgLego::test
