#pragma once

#include <osgLego/AmbientOcclusionSettings.h>
#include <osgLego/LegoSettings.h>

#include <optional>
#include <string>

/** What can be asked of `.legolize`: the keys of osgLego::LegoSettings, and two more.
 *
 * | key       | values                 | default                                                    |
 * |-----------|------------------------|------------------------------------------------------------|
 * | occlusion | off, low, medium, high | medium; with look=plain off                                |
 * | probe     | a picture's file name  | the built-in sky                                           |
 *
 * The file name stands as it is, up to the next comma.
 */
struct LegolizeSettings
{
    /** off, low, medium, high; unset: as the look has it. */
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
    std::string probe; //!< empty: the built-in sky

    /** The settings of the ambient occlusion in force; unset: none. */
    std::optional<osgLego::AmbientOcclusionSettings> getOcclusion() const;

    /** Read `key=value` separated by commas; keys that the text does not name keep the values that `settings` had.
     * @return false, with one sentence in `error` and `settings` unchanged, on a mistake. */
    static bool parse(const std::string& text, LegolizeSettings& settings, std::string& error);

    /** Whether there is a key of that name. */
    static bool isKey(const std::string& name);
};
