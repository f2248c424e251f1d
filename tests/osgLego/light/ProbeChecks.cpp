#include "ProbeChecks.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace osgLego::test
{

osg::ref_ptr<LightProbe> createProbe(const osg::Image* image, LightProbe::Mapping mapping)
{
    osg::ref_ptr<LightProbe> probe = new LightProbe;
    std::string error;
    EXPECT_TRUE(probe->setImage(image, mapping, error)) << error;
    return probe;
}

std::vector<osg::ref_ptr<LightProbe>> createProbes(const RadianceOf& radianceOf)
{
    return {createProbe(createLatitudeLongitude(256, radianceOf)), createProbe(createAngularMap(300, radianceOf))};
}

osg::ref_ptr<osg::Image> createEmptyImage(int width, int height, GLenum format, GLenum type)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, format, type);
    std::memset(image->data(), 0, image->getTotalSizeInBytes());
    return image;
}

RadianceOf constant(double radiance)
{
    return [radiance](const osg::Vec3d&) { return osg::Vec3d(radiance, radiance, radiance); };
}

osg::Vec3d grey(double value)
{
    return {value, value, value};
}

void expectNear(const osg::Vec3d& actual, const osg::Vec3d& expected, double tolerance, const char* subject)
{
    for (unsigned int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(actual[channel], expected[channel], tolerance) << subject << ", channel " << channel;
}

} // namespace osgLego::test
