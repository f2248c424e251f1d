#pragma once

#include <osgLego/Export.h>

#include <array>
#include <string>

#include <osg/Image>
#include <osg/Object>
#include <osg/Quat>
#include <osg/Vec3d>
#include <osg/ref_ptr>

namespace osgLego
{

class ProbeLight;

/** The light that comes from all around: a picture of high dynamic range, or the sky and ground that are built in.
 *
 * Answers with the irradiance upon a surface, by nine spherical harmonics (Ramamoorthi and Hanrahan, "An Efficient
 * Representation for Irradiance Environment Maps", 2001), or by a small convolved map where the light has too much
 * contrast for them; and with pictures of the light filtered for glossy reflection (Karis, "Real Shading in Unreal
 * Engine 4", 2013, with the GGX distribution of Walter et al., "Microfacet Models for Refraction through Rough
 * Surfaces", 2007). Radiance is linear and relative: 1 is what a white surface under the light of 1 from everywhere
 * gives back. Irradiance is over pi, so that radiance 1 from everywhere makes irradiance 1.
 *
 * Coordinates are OpenSceneGraph's, Z up. In the probe's own coordinates, those of its picture:
 *
 * - Latitude and longitude: the middle looks along +Y, to its right is +X; u = 0.5 + atan2(x, y) / (2 pi), and from the
 *   top v = acos(z) / pi.
 * - Angular map (Debevec's): +Y in the middle of the circle, +X to its right, +Z above, -Y all along its rim; the
 *   distance from the middle, over the radius, is acos(y) / pi.
 *
 * As in every osg::Image, row 0 is the bottom one.
 *
 * Preconditions:
 * 1. An image is uncompressed, of one layer, its channels being GL_FLOAT (linear), GL_UNSIGNED_BYTE or
 *    GL_UNSIGNED_SHORT (sRGB display values, made linear), its format one channel of grey (GL_LUMINANCE, GL_RED), or
 *    three or four of colours, whose alpha has no part.
 * 2. It is twice as wide as high, or square (see Mapping).
 * 3. Its pixels are not changed any more, or setImage() is called again: what follows from them is made there.
 *
 * Usage:
 *
 *     std::string error;
 *     osg::ref_ptr<osgLego::LightProbe> probe = osgLego::LightProbe::read("park.exr", error);
 *     if (!probe) std::cerr << error << '\n';
 *     else color = probe->getIrradiance(normal);
 *
 * Free of GL. Functions that are const may be called from any thread while no other function is.
 */
class OSGLEGO_EXPORT LightProbe : public osg::Object
{
public:
    /** How the pixels of a picture lie around the viewer. */
    enum Mapping
    {
        AUTO,               //!< by shape: twice as wide as high is LATITUDE_LONGITUDE, square is ANGULAR
        LATITUDE_LONGITUDE, //!< of any shape, when it is asked for by name
        ANGULAR             //!< square; what lies outside the circle does not count
    };

    static constexpr int REFLECTION_LEVELS = 6;
    static constexpr int REFLECTION_WIDTH = 256; //!< of level 0; twice its height
    static constexpr int CONVOLVED_WIDTH = 64;   //!< of the convolved map; twice its height
    /** The harmonic error from which on the convolved map is used. */
    static constexpr double MAXIMUM_HARMONIC_ERROR = 0.02;

    /** The built-in sky: soft, slightly blue, with a large warm glow to the front right (+X, -Y), over grey ground. */
    LightProbe();
    LightProbe(const LightProbe& probe, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Object(osgLego, LightProbe)

    /** Read a picture through osgDB: by this project's plugin for OpenImageIO, or OSG's own where that is not there.
     * @return null, with one sentence in `error`, when there is no such file, it is damaged, or setImage() refuses
     * it. */
    static osg::ref_ptr<LightProbe> read(const std::string& fileName, std::string& error, Mapping mapping = AUTO);

    /** Take the light from a picture; from the built-in sky when it is null.
     *
     * Pixels that are negative or not numbers count as 0, infinite ones as 65504, and a warning says how many there
     * are. Takes 60 to 100 ms, and 0.1 us a pixel, 0.3 us a pixel of an angular map.
     * @return false, with one sentence in `error` and nothing changed, for an image that does not meet the
     * preconditions, one that has no pixel above 0, and when memory runs out. */
    bool setImage(const osg::Image* image, Mapping mapping, std::string& error);
    /** The picture; null for the built-in sky. */
    const osg::Image* getImage() const { return _image.get(); }
    /** How that was asked to be taken. */
    Mapping getMapping() const { return _mapping; }

    /** The turn from the probe's coordinates to those of the world; none at first. One of no length, or that is not of
     * numbers, is refused with a warning. */
    void setRotation(const osg::Quat& rotation);
    const osg::Quat& getRotation() const { return _rotation; }

    /** What all light is multiplied by, 0 or more; 1 at first. What is below, or not a finite number, is refused with a
     * warning. */
    void setIntensity(double intensity);
    double getIntensity() const { return _intensity; }

    /** The irradiance over pi that is in force for a normal of any length in the coordinates of the world, rotation and
     * intensity included: that of the convolved map, or of the harmonics. Never below 0; 0 for a normal of no length.
     */
    osg::Vec3d getIrradiance(const osg::Vec3d& worldNormal) const;

    // What follows is in the probe's coordinates, and rotation and intensity have no part in it.

    /** The radiance by spherical harmonics: Y00; Y1-1 (y), Y10 (z), Y11 (x); Y2-2 (xy), Y2-1 (yz), Y20 (3z^2 - 1),
     * Y21 (xz), Y22 (x^2 - y^2), with the constants of Ramamoorthi and Hanrahan. */
    const std::array<osg::Vec3d, 9>& getCoefficients() const;

    /** The irradiance over pi by harmonics alone, for a unit normal; what falls below 0 is 0. */
    osg::Vec3d getHarmonicIrradiance(const osg::Vec3d& normal) const;

    /** The irradiance over pi for all normals, by latitude and longitude: CONVOLVED_WIDTH x half of it, GL_RGB,
     * GL_FLOAT.
     *
     * Between pixels it is interpolated linearly, around the sides and across the poles: the neighbour of a pixel of
     * the top row is the one half a turn away in the same row. Shared among probes: to be read alone. */
    osg::Image* getConvolvedMap() const;

    /** How far the harmonics are from the convolved map: the root mean square over the sphere, of the channel where it
     * is largest, over the largest of the channels' means. */
    double getHarmonicError() const;
    /** Whether getIrradiance() answers from the convolved map: the error is above MAXIMUM_HARMONIC_ERROR. */
    bool usesConvolvedMap() const;

    /** The radiance by latitude and longitude, filtered for reflection by a surface of the roughness
     * `level / (REFLECTION_LEVELS - 1)`, perceptual (alpha = roughness^2): the mean weighted by the GGX distribution
     * and the cosine, viewer and normal both being in the middle of the lobe. Level 0 is the picture itself.
     *
     * REFLECTION_WIDTH / 2^level pixels wide and half as high, GL_RGB, GL_FLOAT. Shared among probes: to be read alone.
     * @return null for a level below 0 or from REFLECTION_LEVELS on. */
    osg::Image* getReflectionMap(int level) const;

protected:
    ~LightProbe() override;

private:
    const ProbeLight& getLight() const;

    osg::ref_ptr<const osg::Image> _image;
    Mapping _mapping = AUTO;
    osg::ref_ptr<const ProbeLight> _light; // null: that of the built-in sky
    osg::Quat _rotation;
    double _intensity = 1.0;
};

} // namespace osgLego
