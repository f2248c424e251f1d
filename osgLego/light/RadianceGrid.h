#pragma once

#include <osgLego/light/RadiancePicture.h>

#include <vector>

#include <osg/Image>
#include <osg/Vec3d>
#include <osg/ref_ptr>

namespace osgLego
{

/** The radiance of a picture in fewer cells, by latitude and longitude, row 0 at the bottom.
 *
 * A cell knows where in it the light comes from, so that a lamp that is smaller than a cell stays in its place. */
class RadianceGrid
{
public:
    struct Cell
    {
        osg::Vec3d radiance; //!< the mean over the cell's solid angle
        osg::Vec3d centroid; //!< the mean direction, weighted by radiance: a little shorter than 1
    };

    /** The means over each cell of a picture. */
    RadianceGrid(const RadiancePicture& picture, int width, int height);

    /** The same light in a grid of half the width and height, both of which are even. */
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

/** An image of GL_RGB and GL_FLOAT, its pixels not set. Throws std::bad_alloc where there is no memory for it. */
osg::ref_ptr<osg::Image> createRadianceImage(int width, int height);

} // namespace osgLego
