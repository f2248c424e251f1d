#pragma once

#include <osgLego/Export.h>

#include <optional>
#include <string>

namespace osgLego
{

/** How much work a pixel is worth. */
enum class AmbientOcclusionQuality
{
    LOW,
    MEDIUM,
    HIGH
};

/** What an AmbientOcclusionScene shows. */
enum class AmbientOcclusionOutput
{
    PICTURE,      //!< the scene
    OCCLUSION,    //!< how much of the sky is seen, as grey: white is all of it
    BENT_NORMALS, //!< the mean direction of what is seen, in the eye's coordinates: x, y, z from -1 to 1 as red, green,
                  //!< blue
    IRRADIANCE,   //!< the light of the probe along the bent normal
    NORMALS       //!< the normals of the surface, as the bent ones
};

/** How ambient occlusion is computed and shown, and the one text form of it.
 *
 * A plain value: copy it, change members, hand it to AmbientOcclusionScene::setSettings, which checks it.
 *
 * The text form is a list of `key=value` separated by commas; a quality alone needs no key:
 *
 *     high
 *     low,radius=0.5,show=occlusion
 *
 * | key     | values                                                     | default         |
 * |---------|------------------------------------------------------------|-----------------|
 * | quality | low, medium, high                                          | medium          |
 * | radius  | above 0, in units of the world                             | 2.5 bricks wide |
 * | show    | picture, occlusion, bent-normals, irradiance, normals      | picture         |
 *
 * Every function may be called from any thread on an object that no other thread is changing.
 */
struct OSGLEGO_EXPORT AmbientOcclusionSettings
{
    /** The radius where none is set: so many widths of the widest brick in view. */
    static constexpr double RADIUS_IN_BRICKS = 2.5;
    /** The part of the radius, on its far side, over which things come to occlude. */
    static constexpr double FALLOFF = 0.6;

    AmbientOcclusionQuality quality = AmbientOcclusionQuality::MEDIUM;
    /** How far away things occlude, in units of the world; unset: RADIUS_IN_BRICKS, or where there are no bricks, a
     * twentieth of what the scene is across. */
    std::optional<double> radius;
    AmbientOcclusionOutput output = AmbientOcclusionOutput::PICTURE;

    /** What is wrong with these values and what is allowed instead, in one sentence; empty when nothing is. */
    std::string check() const;

    /** Read the text form; keys that it does not name keep the values that `settings` had.
     * @return false, with one sentence in `error` and `settings` unchanged, on a mistake. */
    static bool parse(const std::string& text, AmbientOcclusionSettings& settings, std::string& error);

    /** The shortest text that parse() turns into these values, beginning with the quality. */
    std::string toString() const;

    bool operator==(const AmbientOcclusionSettings&) const = default;
};

/** Milliseconds that the last frame took in one context, by pass; 0 without AmbientOcclusionScene::setTiming. */
struct AmbientOcclusionTimes
{
    double geometry = 0.0;  //!< drawing the children
    double resolve = 0.0;   //!< samples to one depth a pixel
    double occlusion = 0.0; //!< horizons and their integrals
    double denoise = 0.0;
    double composite = 0.0; //!< irradiance and reflection, into the frame
};

} // namespace osgLego
