#pragma once

#include <osgLego/LightProbe.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <osg/Vec2d>
#include <osg/Vec3d>
#include <osg/Vec3f>

namespace osgLego
{

/** The pixels of a light probe's picture: linear radiance, finite, none below 0.
 *
 * Usage:
 *
 *     std::optional<RadiancePicture> picture = RadiancePicture::read(image, LightProbe::AUTO, error);
 *     if (picture) picture->visit([&](const RadiancePicture::Piece& piece) { sum += piece.radiance * piece.solidAngle;
 * });
 *
 * Const functions may be called from any thread.
 */
class RadiancePicture
{
public:
    /** A pixel, or part of one: so small that its middle may stand for all of it. */
    struct Piece
    {
        osg::Vec3d direction; //!< a unit vector
        osg::Vec2d place;     //!< of the direction in the picture by latitude and longitude
        double solidAngle = 0.0;
        osg::Vec3d radiance;
    };

    /** Check an image and make its pixels linear. @return nothing, with one sentence in `error`, when it is no probe.
     */
    static std::optional<RadiancePicture> read(const osg::Image& image, LightProbe::Mapping mapping,
                                               std::string& error);

    /** A picture by latitude and longitude of what a function of the unit vector says. */
    static RadiancePicture create(int width, int height,
                                  const std::function<osg::Vec3d(const osg::Vec3d& direction)>& radianceOf);

    /** Call a function with all pieces; their solid angles make 4 pi. Large pixels come in several pieces, so that
     * there are at least 512 from left to right, and the pixels on the rim of an angular map are cut by the circle. */
    void visit(const std::function<void(const Piece&)>& function) const;

    /** The pixel in the direction of a unit vector. */
    osg::Vec3d getRadiance(const osg::Vec3d& direction) const;

private:
    RadiancePicture(int width, int height, bool angular);

    const osg::Vec3f& pixel(int column, int row) const;
    void visitLatitudesAndLongitudes(const std::function<void(const Piece&)>& function) const;
    void visitCircle(const std::function<void(const Piece&)>& function) const;
    /** Pixels of no light become black, those of endless light bright. @return whether any gives light. */
    bool mend();

    int _width;
    int _height;
    bool _angular;
    std::vector<osg::Vec3f> _pixels;
};

} // namespace osgLego
