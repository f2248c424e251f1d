#pragma once

#include <osgLego/Export.h>
#include <osgLego/ProbeFormat.h>

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

/** Environment light: a high dynamic range picture, or the built-in sky and ground.
 *
 * Computes the irradiance on a surface, with nine spherical harmonics (Ramamoorthi and Hanrahan, "An Efficient
 * Representation for Irradiance Environment Maps", 2001) or, if the light has too much contrast for them, with a small
 * convolved map. It also creates pictures of the light filtered for glossy reflection (Karis, "Real Shading in Unreal
 * Engine 4", 2013, with the GGX distribution of Walter et al., "Microfacet Models for Refraction through Rough
 * Surfaces", 2007). Radiance is linear and relative: 1 is the radiance of a white surface lit by radiance 1 from all
 * directions. Irradiance is divided by pi, so that radiance 1 from all directions causes irradiance 1.
 *
 * World coordinates are OpenSceneGraph's, with Z up. The coordinates of the probe are defined by its picture:
 *
 * - Latitude and longitude: +Y in the centre, +X to the right of it; u = 0.5 + atan2(x, y) / (2 pi), and, from the top,
 *   v = acos(z) / pi.
 * - Angular map (Debevec's): +Y in the centre of the circle, +X to the right of it, +Z above, -Y along the whole rim;
 * the distance from the centre, divided by the radius, is acos(y) / pi.
 *
 * As in every osg::Image, row 0 is at the bottom.
 *
 * Preconditions:
 * 1. An image is uncompressed and has one layer. Its data type is GL_FLOAT (linear), GL_UNSIGNED_BYTE or
 *    GL_UNSIGNED_SHORT (sRGB display values, converted to linear). It has one grey channel (GL_LUMINANCE, GL_RED), or
 *    three or four colour channels; alpha is ignored.
 * 2. The image is twice as wide as high, or square (see Mapping).
 * 3. After the pixels of the image change, setImage() is called again, since it computes everything from them.
 *
 * Usage:
 *
 *     std::string error;
 *     osg::ref_ptr<osgLego::LightProbe> probe = osgLego::LightProbe::read("park.exr", error);
 *     if (!probe) std::cerr << error << '\n';
 *     else color = probe->getIrradiance(normal);
 *
 * Uses no GL. Const functions may be called from any thread while no non-const function is running.
 */
class OSGLEGO_EXPORT LightProbe : public osg::Object
{
public:
    using Mapping = ProbeFormat::Mapping;
    using enum ProbeFormat::Mapping;

    static constexpr int REFLECTION_LEVELS = ProbeFormat::REFLECTION_LEVELS;
    static constexpr int REFLECTION_WIDTH = ProbeFormat::REFLECTION_WIDTH; //!< pixels, of level 0; twice the height
    static constexpr int CONVOLVED_WIDTH = ProbeFormat::CONVOLVED_WIDTH;   //!< pixels; twice the height
    /** The harmonic error above which the convolved map is used. */
    static constexpr double MAXIMUM_HARMONIC_ERROR = 0.02;

    /** The built-in sky: soft, slightly blue, with a large warm glow to the front right (+X, -Y), over grey ground. */
    LightProbe();
    LightProbe(const LightProbe& probe, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Object(osgLego, LightProbe)

    /** Read a picture with osgDB, using this project's OpenImageIO plugin or, if that is not installed, OSG's plugins.
     * @return null, with one sentence in `error`, if the file doesn't exist, is damaged, or setImage() rejects the
     * image. */
    static osg::ref_ptr<LightProbe> read(const std::string& fileName, std::string& error, Mapping mapping = AUTO);

    /** Use the light of a picture, or of the built-in sky if it is null.
     *
     * Negative and NaN pixels count as 0, infinite ones as 65504; a warning gives their number. Takes 60 to 100 ms,
     * plus 0.1 us per pixel, or 0.3 us per pixel for an angular map.
     * @return false, with one sentence in `error` and nothing changed, if the image does not meet the preconditions, if
     * it has no pixel above 0, or if memory runs out. */
    bool setImage(const osg::Image* image, Mapping mapping, std::string& error);
    /** The picture; null for the built-in sky. */
    const osg::Image* getImage() const { return _image.get(); }
    /** The mapping passed to setImage(). */
    Mapping getMapping() const { return _mapping; }

    /** The rotation from probe coordinates to world coordinates; none by default. A quaternion whose length is 0 or not
     * finite is rejected with a warning. */
    void setRotation(const osg::Quat& rotation);
    const osg::Quat& getRotation() const { return _rotation; }

    /** The factor for all light, 0 or more; 1 by default. A negative or non-finite value is rejected with a warning. */
    void setIntensity(double intensity);
    double getIntensity() const { return _intensity; }

    /** The irradiance, divided by pi, for a normal of any length in world coordinates, from the convolved map or the
     * harmonics (see usesConvolvedMap()). Includes rotation and intensity. Never negative; 0 for a normal of length 0.
     */
    osg::Vec3d getIrradiance(const osg::Vec3d& worldNormal) const;

    // The following functions use probe coordinates and ignore rotation and intensity.

    /** The spherical harmonic coefficients of the radiance: Y00; Y1-1 (y), Y10 (z), Y11 (x); Y2-2 (xy), Y2-1 (yz), Y20
     * (3z^2 - 1), Y21 (xz), Y22 (x^2 - y^2), with the constants of Ramamoorthi and Hanrahan. */
    const std::array<osg::Vec3d, 9>& getCoefficients() const;

    /** The irradiance, divided by pi, from the harmonics only, for a unit normal; negative values become 0. */
    osg::Vec3d getHarmonicIrradiance(const osg::Vec3d& normal) const;

    /** The irradiance, divided by pi, for all normals, by latitude and longitude: CONVOLVED_WIDTH pixels wide, half as
     * high, GL_RGB, GL_FLOAT.
     *
     * getIrradiance() interpolates linearly between pixels, also across the left and right border and across the poles:
     * the upper neighbour of a pixel of the top row is the pixel half a turn away in the same row. The image is shared
     * by probes: only read it. */
    osg::Image* getConvolvedMap() const;

    /** The relative difference between the harmonics and the convolved map: the root mean square difference over the
     * sphere, in the channel where it is largest, divided by the largest mean of a channel. */
    double getHarmonicError() const;
    /** Whether getIrradiance() uses the convolved map, because the error is above MAXIMUM_HARMONIC_ERROR. */
    bool usesConvolvedMap() const;

    /** The radiance by latitude and longitude, filtered for reflection on a surface with the perceptual roughness
     * `level / (REFLECTION_LEVELS - 1)` (alpha = roughness^2): the mean weighted by the GGX distribution and the
     * cosine, where both the view direction and the normal are in the centre of the lobe. Level 0 is the unfiltered
     * picture.
     *
     * REFLECTION_WIDTH / 2^level pixels wide and half as high, GL_RGB, GL_FLOAT. The image is shared by probes: only
     * read it.
     * @return null unless `level` is 0 to REFLECTION_LEVELS - 1. */
    osg::Image* getReflectionMap(int level) const;

protected:
    ~LightProbe() override;

private:
    const ProbeLight& getLight() const;

    osg::ref_ptr<const osg::Image> _image;
    Mapping _mapping = AUTO;
    osg::ref_ptr<const ProbeLight> _light; // null: the light of the built-in sky
    osg::Quat _rotation;
    double _intensity = 1.0;
};

} // namespace osgLego
