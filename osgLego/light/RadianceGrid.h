#pragma once

#include <osgLego/light/RadiancePicture.h>

#include <vector>

#include <osg/Image>
#include <osg/Vec3d>
#include <osg/ref_ptr>

namespace osgLego
{

/** The radiance of a picture, averaged over cells by latitude and longitude, with row 0 at the bottom.
 *
 * Each cell stores the mean direction of its light, so that a lamp smaller than a cell keeps its position. */
class RadianceGrid
{
public:
    struct Cell
    {
        osg::Vec3d radiance; //!< the mean over the cell's solid angle
        osg::Vec3d centroid; //!< the mean direction, weighted by radiance: slightly shorter than 1
    };

    /** Compute the means over the cells of a picture. */
    RadianceGrid(const RadiancePicture& picture, int width, int height);

    /** The same light in a grid of half the width and height; width and height must be even. */
    RadianceGrid halved() const;

    int getWidth() const { return _width; }
    int getHeight() const { return _height; }
    const Cell& getCell(int column, int row) const { return _cells[indexOf(column, row)]; }

    /** The radiance, as GL_RGB and GL_FLOAT. */
    osg::ref_ptr<osg::Image> createImage() const;

private:
    RadianceGrid(int width, int height);

    std::size_t indexOf(int column, int row) const;

    int _width;
    int _height;
    std::vector<Cell> _cells;
};

/** Create an image with GL_RGB and GL_FLOAT and uninitialized pixels. Throws std::bad_alloc if memory runs out. */
osg::ref_ptr<osg::Image> createRadianceImage(int width, int height);

} // namespace osgLego
