#pragma once

#include <osgLego/LightProbe.h>

#include <Probes.h>

#include <vector>

namespace osgLego::test
{

/** A probe with the light of a picture. The test fails if the picture is rejected. */
osg::ref_ptr<LightProbe> createProbe(const osg::Image* image, LightProbe::Mapping mapping = LightProbe::AUTO);

/** Probes with the same light through either mapping. */
std::vector<osg::ref_ptr<LightProbe>> createProbes(const RadianceOf& radianceOf);

/** A picture of zeros. */
osg::ref_ptr<osg::Image> createEmptyImage(int width, int height, GLenum format = GL_RGB, GLenum type = GL_FLOAT);

RadianceOf constant(double radiance);

osg::Vec3d grey(double value);

void expectNear(const osg::Vec3d& actual, const osg::Vec3d& expected, double tolerance, const char* subject = "");

} // namespace osgLego::test
