#pragma once

#include <osgLego/light/RadianceGrid.h>

#include <osg/Image>
#include <osg/ref_ptr>

namespace osgLego
{

/** Compute the irradiance, divided by pi, from the light of a grid for all normals: by latitude and longitude, 64 x 32
 * pixels, where the normal of a pixel is the direction of its centre. Sums over all cells for every pixel. */
osg::ref_ptr<osg::Image> convolveWithCosine(const RadianceGrid& grid);

/** Compute the radiance of a grid in the lobe of a glossy surface: the mean weighted by the GGX distribution (Walter et
 * al. 2007) and the cosine, where both the view direction and the normal are in the centre of the lobe (Karis 2013).
 * @param roughness perceptual, above 0 to 1; alpha is its square.
 * @param width the width of the result in pixels, which is half as high: a multiple of 8, of which the grid's width is
 * a multiple. */
osg::ref_ptr<osg::Image> filterByRoughness(const RadianceGrid& grid, double roughness, int width);

} // namespace osgLego
