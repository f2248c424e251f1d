#pragma once

#include <osgLego/Export.h>
#include <osgLego/SettingDescription.h>

#include <optional>
#include <string>

namespace osgLego
{

/** The amount of work per pixel. */
enum class AmbientOcclusionQuality
{
    LOW,
    MEDIUM,
    HIGH
};

/** The output of an AmbientOcclusionScene. */
enum class AmbientOcclusionOutput
{
    PICTURE,      //!< the scene
    OCCLUSION,    //!< the visible fraction of the sky as grey; white: all of it
    BENT_NORMALS, //!< the mean visible direction in eye coordinates: x, y, z from -1 to 1 as red, green, blue
    IRRADIANCE,   //!< the light of the probe along the bent normal
    NORMALS       //!< the surface normals, with the same colours as the bent normals
};

/** Settings for computing and showing ambient occlusion, and their text form.
 *
 * A plain value: copy it, change members, pass it to AmbientOcclusionScene::setSettings, which checks it.
 *
 * The text form is a list of `key=value` separated by commas; a quality alone needs no key:
 *
 *     high
 *     low,radius=0.5,show=occlusion
 *
 * describe() lists the keys.
 *
 * Every function may be called from any thread on an object that no other thread is changing.
 */
struct OSGLEGO_EXPORT AmbientOcclusionSettings
{
    /** The default radius, in widths of the widest brick in view. */
    static constexpr double RADIUS_IN_BRICKS = 2.5;
    /** The outer part of the radius, over which occlusion fades out. */
    static constexpr double FALLOFF = 0.6;

    AmbientOcclusionQuality quality = AmbientOcclusionQuality::MEDIUM;
    /** The greatest distance of occluders, in world units. Unset: RADIUS_IN_BRICKS brick widths or, if there are no
     * bricks, a twentieth of the scene's diameter. */
    std::optional<double> radius;
    /** Whether bricks are also occluded by bricks of the same node that are farther away than the radius, up to a
     * quarter of the longest side of the node's grid. This is computed once for each brick set, independently of the
     * view; the rest is found in the picture. Without effect if `radius` is set. */
    bool distant = true;
    AmbientOcclusionOutput output = AmbientOcclusionOutput::PICTURE;

    /** The first error in these values, with the expected value, in one sentence; empty if there is none. */
    std::string check() const;

    /** All keys of the text form, in its order. */
    static const SettingDescriptions& describe();

    /** Whether distant bricks occlude, given both settings. */
    bool hasDistant() const { return distant && !radius; }

    /** Read the text form. Settings whose keys are not given keep their values.
     * @return false, with one sentence in `error` and `settings` unchanged, if there is an error. */
    static bool parse(const std::string& text, AmbientOcclusionSettings& settings, std::string& error);

    /** The shortest text from which parse() gets these values, beginning with the quality. */
    std::string toString() const;

    bool operator==(const AmbientOcclusionSettings&) const = default;
};

/** The duration of each pass of the last frame in one context, in milliseconds; 0 without
 * AmbientOcclusionScene::setTiming. */
struct AmbientOcclusionTimes
{
    double geometry = 0.0;  //!< drawing the children
    double resolve = 0.0;   //!< resolving samples to one depth per pixel
    double occlusion = 0.0; //!< horizons and their integrals
    double denoise = 0.0;
    double composite = 0.0; //!< drawing irradiance and reflections into the frame
};

} // namespace osgLego
