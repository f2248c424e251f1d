#pragma once

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/LegoSettings.h>

#include <optional>
#include <string>

/** The settings of `.legolize`: the keys of osgLego::LegoSettings, and three more.
 *
 * | key       | values                 | default                                                    |
 * |-----------|------------------------|------------------------------------------------------------|
 * | occlusion | off, low, medium, high | medium; off with look=plain                                |
 * | distant   | on, off                | on                                                         |
 * | probe     | a picture's file name  | the built-in sky                                           |
 *
 * The file name is not quoted and ends at the next comma.
 */
struct LegolizeSettings
{
    /** off, low, medium, high; unset: depends on the look. */
    enum class Occlusion
    {
        BY_LOOK,
        OFF,
        LOW,
        MEDIUM,
        HIGH
    };

    osgLego::LegoSettings lego;
    Occlusion occlusion = Occlusion::BY_LOOK;
    bool distant = true; //!< whether distant bricks occlude
    std::string probe;   //!< empty: the built-in sky

    /** The settings of ambient occlusion; unset: no ambient occlusion. */
    std::optional<osgLego::AmbientOcclusionSettings> getOcclusion() const;

    /** Read `key=value` separated by commas. Settings whose keys are not given keep their values.
     * @return false, with one sentence in `error` and `settings` unchanged, if there is an error. */
    static bool parse(const std::string& text, LegolizeSettings& settings, std::string& error);

    /** Whether a name is a key. */
    static bool isKey(const std::string& name);
};
