#pragma once

#include <functional>
#include <vector>

#include <osg/Image>
#include <osg/Vec3d>
#include <osg/ref_ptr>

namespace osgLego::test
{

using RadianceOf = std::function<osg::Vec3d(const osg::Vec3d& direction)>;

/** The direction of a pixel's middle, as the comment of LightProbe says it, row 0 at the bottom. */
osg::Vec3d latitudeLongitudeDirection(int column, int row, int width, int height);

/** A picture of floats by latitude and longitude, twice as wide as high. */
osg::ref_ptr<osg::Image> createLatitudeLongitude(int width, const RadianceOf& radianceOf);

/** An angular map of floats; its corners hold what must not count. */
osg::ref_ptr<osg::Image> createAngularMap(int size, const RadianceOf& radianceOf);

osg::Vec3d pixelOf(const osg::Image& image, int column, int row);

/** The mean over the sphere of a picture by latitude and longitude. */
osg::Vec3d meanOf(const osg::Image& image);

/** The irradiance over pi for each normal, from a picture by latitude and longitude: the sum over its pixels, those
 * below 0 left out. */
std::vector<osg::Vec3d> sumIrradiance(const osg::Image& image, const std::vector<osg::Vec3d>& normals);

/** A hundred unit vectors, spread evenly over the sphere. */
std::vector<osg::Vec3d> createNormals();

} // namespace osgLego::test
