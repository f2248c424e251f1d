#pragma once

#include <osgLego/light/RadianceGrid.h>

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** The irradiance over pi that the light of a grid makes for all normals, by latitude and longitude, 64 x 32 pixels,
 * the normals being those of their middles. Every cell counts for every pixel. */
osg::ref_ptr<osg::Image> convolveWithCosine(const RadianceGrid& grid);

/** The radiance of a grid in the lobe of a glossy surface: the mean weighted by the GGX distribution (Walter et al.
 * 2007) and the cosine, viewer and normal both being in the middle of the lobe (Karis 2013).
 * @param roughness perceptual, above 0 to 1; alpha is its square.
 * @param width of the result, which is half as high; the grid's width is a multiple of it. */
osg::ref_ptr<osg::Image> filterByRoughness(const RadianceGrid& grid, double roughness, int width);

} // namespace osgLego
