#include "AmbientOcclusionTest.h"

#include <osg/ShapeDrawable>

namespace osgLego::test
{

void switchLighting(osg::Node& node, bool isOn)
{
    node.getOrCreateStateSet()->setMode(GL_LIGHTING, (isOn ? osg::StateAttribute::ON : osg::StateAttribute::OFF) |
                                                         osg::StateAttribute::PROTECTED);
}

osg::ref_ptr<osg::Geode> createBall(const osg::Vec3& center, float radius, const osg::Vec4& color)
{
    osg::ref_ptr<osg::ShapeDrawable> ball = new osg::ShapeDrawable(new osg::Sphere(center, radius));
    ball->setColor(color);
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(ball);
    return geode;
}

osg::ref_ptr<osg::Group> createMixedScene()
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(createBrickBox({8, 8, 2}, "8", osg::Vec4(0.8f, 0.3f, 0.2f, 1.0f)));
    group->addChild(createBall({5, 3, 3}, 1.2f, osg::Vec4(0.3f, 0.6f, 0.9f, 1.0f)));
    return group;
}

osg::ref_ptr<osg::Image> AmbientOcclusionTest::drawToTexture(osg::Node& scene, const Viewpoint& viewpoint,
                                                             unsigned int samples, osg::Transform::ReferenceFrame frame,
                                                             int scale)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(scale * WIDTH, scale * HEIGHT, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setReferenceFrame(frame);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->attach(osg::Camera::COLOR_BUFFER, image, samples, samples);
    camera->setViewport(0, 0, scale * WIDTH, scale * HEIGHT);
    camera->setClearColor(_viewer.getCamera()->getClearColor());
    if (frame == osg::Transform::ABSOLUTE_RF) viewpoint.apply(*camera);
    camera->addChild(&scene);
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(camera);
    draw(*root, viewpoint);
    return image;
}

AmbientOcclusionTest::Pair AmbientOcclusionTest::drawBoth(osg::Node& root, AmbientOcclusionScene& group,
                                                          const Viewpoint& viewpoint)
{
    Pair pair;
    group.setEnabled(true);
    pair.with = draw(root, viewpoint);
    group.setEnabled(false);
    pair.without = draw(root, viewpoint);
    return pair;
}

} // namespace osgLego::test
