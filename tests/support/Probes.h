#pragma once

#include <functional>
#include <vector>

#include <osg/Image>
#include <osg/Vec3d>
#include <osg/ref_ptr>

namespace osgLego::test
{

using RadianceOf = std::function<osg::Vec3d(const osg::Vec3d& direction)>;

/** The direction of a pixel's centre, as documented in LightProbe, row 0 at the bottom. */
osg::Vec3d latitudeLongitudeDirection(int column, int row, int width, int height);

/** A floating-point latitude-longitude picture, twice as wide as high. */
osg::ref_ptr<osg::Image> createLatitudeLongitude(int width, const RadianceOf& radianceOf);

/** A floating-point angular map; its corners contain values that must be ignored. */
osg::ref_ptr<osg::Image> createAngularMap(int size, const RadianceOf& radianceOf);

osg::Vec3d pixelOf(const osg::Image& image, int column, int row);

/** The mean of a latitude-longitude picture over the sphere. */
osg::Vec3d meanOf(const osg::Image& image);

/** The irradiance divided by pi, for each normal, of a latitude-longitude picture: the sum over its pixels, except
 * negative ones. */
std::vector<osg::Vec3d> sumIrradiance(const osg::Image& image, const std::vector<osg::Vec3d>& normals);

/** A hundred unit vectors, distributed evenly over the sphere. */
std::vector<osg::Vec3d> createNormals();

} // namespace osgLego::test
