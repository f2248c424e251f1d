#pragma once

#include <osgLego/ProbeFormat.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <osg/Image>
#include <osg/Vec2d>
#include <osg/Vec3d>
#include <osg/Vec3f>

namespace osgLego
{

/** The pixels of a light probe's picture: linear radiance, finite and not negative.
 *
 * Usage:
 *
 *     std::optional<RadiancePicture> picture = RadiancePicture::read(image, LightProbe::AUTO, error);
 *     const auto add = [&](const RadiancePicture::Piece& piece) { sum += piece.radiance * piece.solidAngle; };
 *     if (picture) picture->visit(add);
 *
 * Const functions may be called from any thread.
 */
class RadiancePicture
{
public:
    /** A pixel or part of a pixel, small enough to be represented by its centre. */
    struct Piece
    {
        osg::Vec3d direction; //!< a unit vector
        osg::Vec2d place;     //!< the position of the direction in a picture by latitude and longitude
        double solidAngle = 0.0;
        osg::Vec3d radiance;
    };

    /** Check an image and convert its pixels to linear values. @return nothing, with one sentence in `error`, if the
     * image can't be used as a light probe. */
    static std::optional<RadiancePicture> read(const osg::Image& image, ProbeFormat::Mapping mapping,
                                               std::string& error);

    /** Create a picture by latitude and longitude from a function that gives the radiance in the direction of a unit
     * vector. */
    static RadiancePicture create(int width, int height,
                                  const std::function<osg::Vec3d(const osg::Vec3d& direction)>& radianceOf);

    /** Call a function with all pieces; their solid angles add up to 4 pi. Large pixels are divided, so that there are
     * at least 512 pieces from left to right. The pixels on the rim of an angular map are cut by the circle. */
    void visit(const std::function<void(const Piece&)>& function) const;

    /** The pixel in the direction of a unit vector. */
    osg::Vec3d getRadiance(const osg::Vec3d& direction) const;

private:
    RadiancePicture(int width, int height, bool angular);

    const osg::Vec3f& pixel(int column, int row) const;
    void visitLatitudesAndLongitudes(const std::function<void(const Piece&)>& function) const;
    void visitCircle(const std::function<void(const Piece&)>& function) const;
    /** Set negative and NaN pixels to 0, infinite ones to a large value. @return whether any pixel is finite and above
     * 0. */
    bool mend();

    int _width;
    int _height;
    bool _angular;
    std::vector<osg::Vec3f> _pixels;
};

} // namespace osgLego
